#pragma once

#include "scene/view.h"

namespace alpenglow {

/// A scene by itself, as a photographer of things would stand it: no planet, an even fill light, a key light from above
/// the camera, a plain backdrop. A white surface that faces the key light shows white, and an unlit one
/// shows its base colour.
struct StudioShot {
    Placement placement; ///< scales the scene to one size, so that nothing depends on how large it is
    World world;
};

/// Frames `bounds` (scene frame, not empty) in a picture of this aspect, width over height. The front is +Z, as
/// glTF says: boards are seen from there, other flat things along their flat axis (maps from above), the rest a little
/// from the right and from above.
StudioShot make_studio_shot(Box const& bounds, double aspect);

/// How such a picture is exposed and drawn: linear, so that colours are those of the file, and with smooth edges.
Settings studio_settings();

} // namespace alpenglow
