#include "speech/sentences/sentence_grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/number.hpp"
#include "core/text.hpp"

namespace deixis::speech {

namespace {

/// Reads line by line: first all names, so that rules may be used before they stand there.
class GrammarReader {
  public:
    GrammarReader(std::string_view text, const std::string& name) : name_(name) {
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            lines_.push_back(text.substr(at, end - at));
            at = end + 1;
        }
    }

    Result<SentenceGrammar> read() {
        if (auto named = readNames(); !named) return tl::unexpected(named.error());
        for (line_ = 1; line_ <= static_cast<int>(lines_.size()); ++line_)
            if (auto done = readLine(lines_[static_cast<std::size_t>(line_ - 1)]); !done)
                return tl::unexpected(done.error());
        if (auto whole = check(); !whole) return tl::unexpected(whole.error());
        return std::move(grammar_);
    }

  private:
    enum class LineKind : unsigned char { nothing, theme, rule, alternatives };

    static LineKind kindOf(std::string_view line) {
        const std::string_view content = trimmed(line);
        if (content.empty() || line.front() == '#') return LineKind::nothing;
        if (line.front() == ' ') return LineKind::alternatives;
        return content.back() == ':' ? LineKind::rule : LineKind::theme;
    }

    [[nodiscard]] tl::unexpected<Error> bad(std::string message, std::string hint = {}) const {
        return fail(fmt::format("{}:{}", name_, line_), std::move(message), std::move(hint));
    }

    Result<void> readNames() {
        for (line_ = 1; line_ <= static_cast<int>(lines_.size()); ++line_) {
            const std::string_view line = lines_[static_cast<std::size_t>(line_ - 1)];
            if (kindOf(line) != LineKind::rule) continue;
            const std::string rule(trimmed(line.substr(0, line.rfind(':'))));
            if (!places_.emplace(rule, static_cast<int>(grammar_.rules.size())).second)
                return bad(fmt::format("found rule \"{}\" a second time", rule));
            grammar_.rules.push_back({rule, line_});
        }
        return {};
    }

    Result<void> readLine(std::string_view line) {
        switch (kindOf(line)) {
            case LineKind::nothing:
                return {};
            case LineKind::theme:
                return readTheme(trimmed(line));
            case LineKind::rule:
                rule_ = places_.find(trimmed(line.substr(0, line.rfind(':'))))->second;
                return {};
            case LineKind::alternatives:
                if (rule_ < 0) return bad("found alternatives before the first rule");
                return readAlternatives(trimmed(line), rule_, true);
        }
        return {};
    }

    Result<int> placeOf(std::string_view rule) const {
        const auto found = places_.find(rule);
        if (found == places_.end()) return bad(fmt::format("found no rule \"{}\"", rule));
        return found->second;
    }

    Result<void> readTheme(std::string_view line) {
        constexpr std::string_view word = "theme ";
        const auto parts = nameAndValue(line);
        if (!line.starts_with(word) || !parts)
            return bad(fmt::format("found \"{}\", expected \"theme NAME = RULES\" or \"RULE:\"", line));
        GrammarTheme theme{std::string(trimmed(std::string_view(parts->first).substr(word.size()))), line_};
        std::string_view rest = trimmed(parts->second);
        bool has_many = false;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            std::string_view rule = rest.substr(0, end);
            GrammarStage stage;
            if (rule.back() == '?') stage.times = GrammarStage::Times::maybe;
            if (rule.back() == '+') stage.times = GrammarStage::Times::many;
            if (stage.times != GrammarStage::Times::once) rule.remove_suffix(1);
            const auto place = placeOf(rule);
            if (!place) return tl::unexpected(place.error());
            stage.rule = *place;
            if (stage.times == GrammarStage::Times::many && has_many)
                return bad("found a second rule with +, expected one at the most");
            has_many = has_many || stage.times == GrammarStage::Times::many;
            theme.stages.push_back(stage);
            rest = trimmed(rest.substr(end));
        }
        grammar_.themes.push_back(std::move(theme));
        return {};
    }

    /// The text's parts between separators that stand in no brackets.
    Result<std::vector<std::string_view>> split(std::string_view text, char separator) const {
        std::vector<std::string_view> parts;
        int depth = 0;
        std::size_t start = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '[') ++depth;
            if (text[i] == ']' && --depth < 0) return bad("found ] without [");
            if (text[i] == separator && depth == 0) {
                parts.push_back(text.substr(start, i - start));
                start = i + 1;
            }
        }
        if (depth > 0) return bad("found [ without ]");
        parts.push_back(text.substr(start));
        return parts;
    }

    /// Adds a line's alternatives. Those of a rule of its own have forms, and none is empty.
    Result<void> readAlternatives(std::string_view text, int rule, bool named) {
        const auto alternatives = split(text, '|');
        if (!alternatives) return tl::unexpected(alternatives.error());
        for (const std::string_view alternative : *alternatives) {
            std::vector<GrammarForm> forms;
            auto texts = named ? split(alternative, '/') : std::vector<std::string_view>{alternative};
            if (!texts) return tl::unexpected(texts.error());
            for (const std::string_view form_text : *texts) {
                auto form = readForm(named ? trimmed(form_text) : form_text);
                if (!form) return tl::unexpected(form.error());
                if (named && form->empty()) return bad("found an empty alternative");
                forms.push_back(std::move(*form));
            }
            grammar_.rules[static_cast<std::size_t>(rule)].alternatives.push_back(std::move(forms));
        }
        return {};
    }

    Result<GrammarForm> readForm(std::string_view text) {
        GrammarForm form;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find_first_of("{}[", at), text.size());
            if (end > at) form.push_back({std::string(text.substr(at, end - at))});
            if (end == text.size()) break;
            if (text[end] == '}') return bad("found } without {");
            auto close = text[end] == '{' ? text.find('}', end) : closeOf(text, end);
            if (close == std::string_view::npos) return bad("found { without }");
            const std::string_view inner = text.substr(end + 1, close - end - 1);
            auto piece = text[end] == '{' ? readReference(inner) : readChoice(inner);
            if (!piece) return tl::unexpected(piece.error());
            form.push_back(std::move(*piece));
            at = close + 1;
        }
        return form;
    }

    /// Where the bracket at `open` closes; split() has seen that it does.
    static std::size_t closeOf(std::string_view text, std::size_t open) {
        int depth = 0;
        for (std::size_t i = open; i < text.size(); ++i) {
            if (text[i] == '[') ++depth;
            if (text[i] == ']' && --depth == 0) return i;
        }
        return std::string_view::npos;
    }

    Result<GrammarPiece> readChoice(std::string_view inner) {
        GrammarPiece piece;
        piece.rule = static_cast<int>(grammar_.rules.size());
        grammar_.rules.push_back({"", line_});
        if (auto read = readAlternatives(inner, piece.rule, false); !read)
            return tl::unexpected(read.error());
        return piece;
    }

    Result<GrammarPiece> readReference(std::string_view inner) const {
        GrammarPiece piece;
        std::string_view rule = inner;
        const auto takeNumber = [&](char mark) -> std::optional<int> {
            const std::size_t at = rule.rfind(mark);
            if (at == std::string_view::npos) return 0;
            const auto number = naturalNumber(rule.substr(at + 1));
            if (!number || *number < 1 || *number > 9) return {};
            rule = rule.substr(0, at);
            return static_cast<int>(*number);
        };
        const auto form = takeNumber('.');
        const auto label = form ? takeNumber('#') : form;
        if (!label)
            return bad(fmt::format("found \"{{{}}}\", expected {{RULE}}, {{RULE.2}} or {{RULE#1.2}}", inner));
        const auto place = placeOf(rule);
        if (!place) return tl::unexpected(place.error());
        piece.rule = *place;
        piece.form = *form > 0 ? static_cast<std::size_t>(*form - 1) : 0;
        piece.label = *label;
        return piece;
    }

    Result<void> check() {
        std::vector<bool> used(grammar_.rules.size(), false);
        for (const GrammarTheme& theme : grammar_.themes)
            for (const GrammarStage& stage : theme.stages) used[static_cast<std::size_t>(stage.rule)] = true;
        for (const GrammarRule& rule : grammar_.rules) {
            line_ = rule.line;
            if (rule.alternatives.empty())
                return bad(fmt::format("found no alternative of \"{}\"", rule.name));
            for (const auto& forms : rule.alternatives)
                for (const GrammarForm& form : forms)
                    for (const GrammarPiece& piece : form) {
                        if (piece.rule < 0) continue;
                        used[static_cast<std::size_t>(piece.rule)] = true;
                        if (auto fits = checkReference(piece, rule); !fits) return fits;
                    }
        }
        for (std::size_t r = 0; r < grammar_.rules.size(); ++r) {
            line_ = grammar_.rules[r].line;
            if (!used[r])
                return bad(fmt::format("found rule \"{}\", which nothing uses", grammar_.rules[r].name));
            if (!ends(r, 0))
                return bad(fmt::format("found rule \"{}\", which is made of itself", grammar_.rules[r].name));
        }
        line_ = 1;
        if (grammar_.themes.empty()) return bad("found no theme");
        return {};
    }

    Result<void> checkReference(const GrammarPiece& piece, const GrammarRule& user) const {
        const GrammarRule& rule = grammar_.rules[static_cast<std::size_t>(piece.rule)];
        for (const auto& forms : rule.alternatives) {
            if (forms.size() <= piece.form)
                return fail(fmt::format("{}:{}", name_, rule.line),
                            fmt::format("found an alternative of \"{}\" without form {}, which \"{}\" uses",
                                        rule.name, piece.form + 1, user.name));
            if (piece.label == 0) continue;
            for (const GrammarForm& form : forms)
                if (form.size() != 1 || form.front().rule >= 0)
                    return fail(fmt::format("{}:{}", name_, rule.line),
                                fmt::format("found \"{}\" with a label, expected words alone", rule.name));
        }
        return {};
    }

    [[nodiscard]] bool ends(std::size_t rule, std::size_t depth) const {
        if (depth > grammar_.rules.size()) return false;
        for (const auto& forms : grammar_.rules[rule].alternatives)
            for (const GrammarForm& form : forms)
                for (const GrammarPiece& piece : form)
                    if (piece.rule >= 0 && !ends(static_cast<std::size_t>(piece.rule), depth + 1))
                        return false;
        return true;
    }

    std::string name_;
    std::vector<std::string_view> lines_;
    std::map<std::string, int, std::less<>> places_;
    SentenceGrammar grammar_;
    int line_ = 0;
    int rule_ = -1;
};

}  // namespace

Result<SentenceGrammar> parseSentenceGrammar(std::string_view text, const std::string& name) {
    return GrammarReader(withoutByteOrderMark(text), name).read();
}

}  // namespace deixis::speech
