// The step from schema version 4 to 5: each participant who has begun gets a token.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include "results/database/participant_token.hpp"

namespace deixis::results {

/// What a participant's token is made from. Tables of versions 4 and 5; the columns in the order of
/// BeforeTokens.
extern const char* const before_tokens_sql;

/// Failing SQLite calls throw.
void migrateTo5(SQLite::Database& database);

}  // namespace deixis::results
