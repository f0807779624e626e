#include "results/outputs/observers_json.hpp"

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

}  // namespace deixis::results
