// Where a mesh's vertex stands, seen from the camera.
#ifndef ALPENGLOW_FRAME_MESH_TRANSFORM
#define ALPENGLOW_FRAME_MESH_TRANSFORM
#include "interop/gbuffer.h"
SHADER_NAMESPACE_BEGIN

// World axes, from the camera [m]. The camera is subtracted in the mesh's own frame and in two floats, so that a vertex keeps
// its place to 1e-7 of its distance wherever the mesh's origin is.
INLINE vec3 relative_from_mesh(MeshDraw draw, vec3 position) {
    return draw.world_from_mesh * ((position - draw.camera_high) - draw.camera_low);
}

SHADER_NAMESPACE_END
#endif
