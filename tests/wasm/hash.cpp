// core/hash.hpp by what runs the tests, Node.js: the product's own needs OpenSSL.
#include "core/hash.hpp"

#include <emscripten.h>

namespace deixis {

std::string sha256Hex(std::string_view bytes) {
    std::string out(64, '0');
    EM_ASM(
        {
            const hash = require("crypto").createHash("sha256");
            const hex = hash.update(HEAPU8.subarray($0, $0 + $1)).digest("hex");
            for (let i = 0; i < hex.length; ++i) HEAPU8[$2 + i] = hex.charCodeAt(i);
        },
        bytes.data(), bytes.size(), out.data());
    return out;
}

}  // namespace deixis
