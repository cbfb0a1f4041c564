// Passes that make the tables of a model of the air, each table in steps: a step's workgroups stand in a row, so that a
// frame can run any part of them.
#ifndef ALPENGLOW_INTEROP_AIR_TABLES_H
#define ALPENGLOW_INTEROP_AIR_TABLES_H
#include "interop/language.h"

SHADER_NAMESPACE_BEGIN
struct AirTablePush {
    int first_group; // of this frame
    int mode;        // the pass's own
};
SHADER_NAMESPACE_END

#endif
