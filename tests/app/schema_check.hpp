// Outputs against the JSON Schemas that ship.
#pragma once

#include "program.hpp"

namespace deixis::tests {

inline std::string shippedSchema(const std::string& name) {
    return sourceDir().string() + "/assets/data/schemas/" + name + ".schema.json";
}

/// What is wrong with a file by the schema of that name ("analysis", ...); empty: nothing. A key that the
/// schema does not know is wrong: describe it there. Debian's Python first, which has the package; where none
/// has it, the file is not looked at, and a message says so.
inline std::string schemaProblems(const std::string& name, const std::string& file) {
    for (const std::string python : {"/usr/bin/python3", "python3"}) {
        if (shell(python + " -c 'import jsonschema'").status != 0) continue;
        const auto done = shell(python + " " + sourceDir().string() + "/tests/app/validate.py " +
                                shippedSchema(name) + " '" + file + "'");
        return done.status == 0 ? done.out : done.out + done.err + "validate.py failed";
    }
    tellSkipped("there is no Python with jsonschema");
    return "";
}

}  // namespace deixis::tests
