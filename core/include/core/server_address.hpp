// Addresses of PostgreSQL servers as people type them, and without passwords as they are printed or
// stored.
#pragma once

#include <string>
#include <string_view>

namespace deixis {

/// Whether it begins postgresql:// or postgres://.
[[nodiscard]] bool isServerAddress(std::string_view text);

/// Whether it was meant to be one: also with a slip in the scheme ("Postgresql://", "postgresq:/"), or of
/// another kind, with a user.
[[nodiscard]] bool looksLikeServerAddress(std::string_view text);

/// Whether user and password, where there are any, can be told from host, port and database without doubt:
/// not where a password holds @ or / as they are, or where no @ follows it.
[[nodiscard]] bool isPlainServerAddress(std::string_view address);

/// The text with each server's address in it as it may be shown: without password, and without the parameters
/// that do not tell which server it is. An address that is not plain becomes "postgresql://...". What may be
/// an address with a slip in it ("Postgresql://ann:secret@host", "ann:secret@host", "password=secret") is cut
/// before the password, too.
[[nodiscard]] std::string withoutPasswords(std::string_view text);

}  // namespace deixis
