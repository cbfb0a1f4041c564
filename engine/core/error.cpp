#include "core/error.h"

#include <algorithm>

namespace alpenglow {

Error::Error(ErrorKind kind, std::string what, std::string where, std::string advice) : kind_(kind) {
    line_ = where.empty() ? std::move(what) : where + ": " + what;
    if (!advice.empty()) line_ += " (" + advice + ")";
    std::replace_if(line_.begin(), line_.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
}

} // namespace alpenglow
