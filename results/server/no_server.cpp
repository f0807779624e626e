// In a program built without DEIXIS_SERVER.
#include "core/server_address.hpp"
#include "results/server/server.hpp"

namespace deixis::results {

namespace {

tl::unexpected<Error> withoutServer(const std::string& address) {
    return fail(withoutPasswords(address), "cannot be reached: this program was built without PostgreSQL",
                "Use one built with DEIXIS_SERVER=ON (docs/server.md)");
}

}  // namespace

Result<PushOutcome> pushDatabase(const std::filesystem::path& /*database*/, const std::string& address) {
    return withoutServer(address);
}

Result<ResponseTable> loadServerResponses(const std::string& address, const std::string& /*study*/) {
    return withoutServer(address);
}

}  // namespace deixis::results
