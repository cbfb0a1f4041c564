#include "core/error.h"

#include "core/plain_text.h"

namespace alpenglow {

Error::Error(ErrorKind kind, std::string what, std::string where, std::string advice) : kind_(kind) {
    line_ = where.empty() ? std::move(what) : where + ": " + what;
    if (!advice.empty()) line_ += " (" + advice + ")";
    line_ = plain_text(line_);
}

} // namespace alpenglow
