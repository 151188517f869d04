// SPDX-License-Identifier: MIT
#include "tools/show/view/token.h"

#include <sys/random.h>

#include <cstddef>

namespace crevice {

Result<std::string> randomToken()
{
    constexpr char kDigits[] = "0123456789abcdef";
    unsigned char bytes[16];
    if (getrandom(bytes, sizeof(bytes), 0) != static_cast<ssize_t>(sizeof(bytes)))
        return Diagnostic{Code::cannot_serve, "the system gives no random numbers"};
    std::string token;
    for (const unsigned char byte : bytes) {
        token += kDigits[byte >> 4];
        token += kDigits[byte & 15];
    }
    return token;
}

bool sameSecret(std::string_view given, std::string_view secret)
{
    if (given.size() != secret.size()) return false;
    unsigned differing = 0;
    for (std::size_t k = 0; k < secret.size(); ++k)
        differing |= static_cast<unsigned char>(given[k]) ^ static_cast<unsigned char>(secret[k]);
    return differing == 0;
}

}  // namespace crevice
