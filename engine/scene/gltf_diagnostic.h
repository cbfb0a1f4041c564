#pragma once

#include "core/error.h"

#include <string>

namespace alpenglow {

/// One thing that is wrong with a glTF file.
struct GltfDiagnostic {
    std::string pointer; ///< JSON pointer of the value ("/accessors/3/count"); empty: the file as a whole
    std::string code;    ///< the official validator's where one fits, else ours; all are in scene/gltf_codes.h
    std::string message;
};

/// "POINTER: MESSAGE [CODE]"; without the code where it says nothing more.
std::string line_of(GltfDiagnostic const& diagnostic);

/// Why a glTF file is refused. Its line is "FILE: POINTER: MESSAGE [CODE] (ADVICE)".
class GltfError : public Error {
public:
    GltfError(GltfDiagnostic diagnostic, std::string const& file, std::string const& advice)
        : Error(ErrorKind::bad_input, line_of(diagnostic), file, advice), diagnostic_(std::move(diagnostic)) {}

    GltfDiagnostic const& diagnostic() const { return diagnostic_; }

private:
    GltfDiagnostic diagnostic_;
};

} // namespace alpenglow
