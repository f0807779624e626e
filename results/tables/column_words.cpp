#include "column_words.hpp"

#include <algorithm>
#include <iterator>

namespace deixis::results {

ColumnWords columnWords(std::string_view name) {
    using enum Format;
    static constexpr ColumnWords known_columns[]{
        {"a", "A"},
        {"a12", "A\u2081\u2082"},
        {"b", "B"},
        {"bound", "Bound", nullptr, score},
        {"chi2", "\u03c7\u00b2", "$\\chi^2$"},
        {"choice", nullptr, nullptr, key},
        {"cliffs_delta", "\u03b4", "$\\delta$"},
        {"df1", nullptr, "df$_1$"},
        {"df2", nullptr, "df$_2$"},
        {"f", "F (Iman\u2013Davenport)", "$F$"},
        {"hodges_lehmann", "Shift", "shift", score},
        {"interval", "Interval", nullptr, score},
        {"kendalls_w", "Kendall's W", "Kendall's $W$"},
        {"krippendorff_alpha", "\u03b1", "$\\alpha$"},
        {"mean", "Mean", nullptr, score},
        {"mean_a", "Mean A", nullptr, score},
        {"mean_b", "Mean B", nullptr, score},
        {"mean_difference", "Mean A \u2212 B", nullptr, score},
        {"measure", "Measure", nullptr, title},
        {"median", "Median", nullptr, score},
        {"median_a", "Median A", "median A", score},
        {"median_b", "Median B", "median B", score},
        {"median_s", "Median", "median"},
        {"method", "Method"},
        {"n", nullptr, "$n$"},
        {"n_a", "n A", "$n_a$"},
        {"n_b", "n B", "$n_b$"},
        {"n_negative", "\u2212"},
        {"n_positive", "+"},
        {"n_zero", "zeros", "zeros"},
        {"p", nullptr, "$p$", p_value},
        {"p_f", "p", "$p_F$", p_value},
        {"p_holm", "p (Holm)", "$p_\\mathrm{Holm}$", p_value},
        {"p_holm_pratt", "p (Pratt, Holm)", nullptr, p_value},
        {"p_pratt", "p (Pratt)", nullptr, p_value},
        {"q05", "5\u00a0%", "5 \\%", score},
        {"q25", "25\u00a0%", "25 \\%", score},
        {"q25_s", "25\u00a0%", "25 \\%"},
        {"q75", "75\u00a0%", "75 \\%", score},
        {"q75_s", "75\u00a0%", "75 \\%"},
        {"q95", "95\u00a0%", "95 \\%", score},
        {"rank_biserial", "r", "$r$"},
        {"score", "Score"},
        {"sd", "SD", "SD", score},
        {"sd_participants", "SD participants", "SD (participants)", score},
        {"sd_trials", "SD trials", "SD (trials)", score},
        {"shapiro_p", "Shapiro\u2013Wilk p", nullptr, p_value},
        {"stage", "Stage"},
        {"study", "Study"},
        {"system", "System"},
        {"u", "U", "$U$", rank},
        {"verdict", "Result"},
        {"w_minus", "W\u2212", nullptr, rank},
        {"w_plus", "W+", "$W^+$", rank},
    };
    const auto* const found = std::find_if(std::begin(known_columns), std::end(known_columns),
                                           [&](const ColumnWords& one) { return one.name == name; });
    return found == std::end(known_columns) ? ColumnWords{name} : *found;
}

}  // namespace deixis::results
