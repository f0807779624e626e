#include "results/outputs/observers_tables.hpp"

#include "results/tables/csv_table.hpp"

namespace deixis::results {

nlohmann::ordered_json readingsJson(const std::vector<ObserverReading>& readings) {
    auto out = nlohmann::ordered_json::array();
    for (const ObserverReading& one : readings) {
        nlohmann::ordered_json by_observer;
        for (std::size_t i = 0; i < observer_names.size(); ++i)
            by_observer[observer_names[i]] = {{"accuracy", one.accuracy[i]},
                                              {"without_error", one.without_error[i]}};
        out.push_back({{"system", one.system},
                       {"layout", one.layout},
                       {"trials", one.trials},
                       {"observers", std::move(by_observer)}});
    }
    return out;
}

std::string readingsCsv(const std::vector<ObserverReading>& readings) {
    using enum ColumnType;
    CsvTable table({{"system", text, ""},
                    {"layout", text, ""},
                    {"observer", text, ""},
                    {"trials", number, ""},
                    {"accuracy", number, ""},
                    {"without_error", number, ""}});
    for (const ObserverReading& one : readings)
        for (std::size_t i = 0; i < observer_names.size(); ++i) {
            table.text(one.system);
            table.text(one.layout);
            table.text(observer_names[i]);
            table.number(one.trials);
            table.number(one.accuracy[i]);
            table.number(one.without_error[i]);
            table.endRow();
        }
    return table.take();
}

}  // namespace deixis::results
