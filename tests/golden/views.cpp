#include "core/files.h"
#include "image/codec.h"
#include "image/compare.h"
#include "support/stage_test.h"
#include "terrain/terrain.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

using namespace alpenglow;
namespace fs = std::filesystem;

namespace {

constexpr Extent SIZE{320, 180};
constexpr Extent SKETCH_SIZE{80, 45}; // of the pictures that show what a wrong render changes

/// How far a picture may be from its reference.
struct Tolerance {
    int largest;  ///< [1/255] what a channel may differ by
    double share; ///< of the pixels that may differ by more
};

// References are made on lavapipe. There one processor gives the same bytes in every run, with any number of threads; another
// instruction set moves a few hundred of the 172 800 bytes by at most 2. A pixel in a thousand may be an edge that falls the other way.
constexpr Tolerance ON_SOFTWARE{2, 0.001};
// Other devices round, filter and interpolate in other ways: some steps more everywhere, and other coverage along edges.
constexpr Tolerance ON_A_GPU{6, 0.01};

/// A change that a reference has to notice.
enum class Wrong { sun_moved, no_multiple_scattering, no_shadows, no_shafts };

/// Every view must notice another sun and air that scatters once. Shadows and shafts matter where they cover enough
/// of the picture: at noon nothing stands in the sun's way, and from orbit the scene is small.
std::map<std::string, std::set<Wrong>> const ALSO_NOTICED = {
    {"valley_dawn", {Wrong::no_shadows, Wrong::no_shafts}},
    {"ridge_sunset", {Wrong::no_shadows, Wrong::no_shafts}},
    {"high_12km", {Wrong::no_shadows}},
};

std::set<Wrong> must_notice(std::string const& view) {
    std::set<Wrong> result{Wrong::sun_moved, Wrong::no_multiple_scattering};
    if (auto const found = ALSO_NOTICED.find(view); found != ALSO_NOTICED.end()) result.insert(found->second.begin(), found->second.end());
    return result;
}

fs::path view_file(std::string const& view) { return fs::path(ALPENGLOW_SOURCE) / "assets/views" / (view + ".json"); }

/// Planet by planet: each has its tables.
std::vector<std::string> view_names() {
    std::vector<std::string> names;
    for (fs::directory_entry const& entry : fs::directory_iterator(fs::path(ALPENGLOW_SOURCE) / "assets/views")) {
        if (entry.is_regular_file()) names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names, {}, [](std::string const& name) { return std::pair(load_view(view_file(name)).planet, name); });
    return names;
}

fs::path reference_file(std::string const& view) { return fs::path(ALPENGLOW_SOURCE) / "tests/golden/pictures" / (view + ".png"); }

/// Where pictures of a failure go.
fs::path report_file(std::string const& view, std::string const& what) { return fs::path(ALPENGLOW_SOURCE) / "out/test/golden" / (view + what + ".png"); }

ByteImage shifted_by_a_pixel(ByteImage const& picture) {
    ByteImage shifted(picture.extent);
    for (std::uint32_t y = 0; y < picture.extent.height; ++y) {
        for (std::uint32_t x = 0; x < picture.extent.width; ++x) std::copy_n(picture.at(x ? x - 1 : 0, y), 4, shifted.at(x, y));
    }
    return shifted;
}

View wrong_view(View view, Wrong wrong) {
    switch (wrong) {
    case Wrong::sun_moved:
        view.sun.azimuth += glm::radians(20.0);
        view.sun.elevation -= glm::radians(10.0);
        break;
    case Wrong::no_shadows: view.settings.shadows = false; break;
    case Wrong::no_shafts: view.settings.shafts = "off"; break;
    case Wrong::no_multiple_scattering: view.settings.multiple_scattering = false; break;
    }
    return view;
}

char const* words(Wrong wrong) {
    switch (wrong) {
    case Wrong::sun_moved: return "with the sun moved by 20 degrees across and 10 down";
    case Wrong::no_shadows: return "without shadows";
    case Wrong::no_shafts: return "without light shafts";
    case Wrong::no_multiple_scattering: return "without multiple scattering";
    }
    return "";
}

/// The picture, its reference and both beside their difference, for people.
std::string report(std::string const& view, ByteImage const& picture, ByteImage const& reference) {
    write_png(report_file(view, ""), picture);
    write_png(report_file(view, "_reference"), reference);
    write_png(report_file(view, "_difference"), side_by_side(picture, reference));
    return "the picture, the reference and their difference (times 8): " + report_file(view, "").string() + ", " +
           report_file(view, "_reference").string() + ", " + report_file(view, "_difference").string();
}

void update(std::string const& view, ByteImage const& picture) {
    fs::path const file = reference_file(view);
    if (!fs::exists(file)) {
        std::printf("%s: new reference %s\n", view.c_str(), file.c_str());
    } else if (ByteImage const before = read_picture(file); !(picture.extent == before.extent)) {
        std::printf("%s: reference of another size replaced: %s\n", view.c_str(), file.c_str());
    } else if (picture.rgba == before.rgba) {
        return;
    } else {
        std::printf("%s: reference replaced; look at %s\n", view.c_str(), report(view, picture, before).c_str());
    }
    write_png(file, picture);
}

class Golden : public test::StageTest, public testing::WithParamInterface<std::string> {
protected:
    static ByteImage paint(View const& view, Extent size = SIZE) {
        World const world = stage().prepare(view);
        stage().draw(view, world, size);
        return stage().renderer().picture();
    }
    /// Small and without supersampling: two of them are off from each other as pictures are, at 1/64 of the samples.
    static ByteImage sketch(View view) {
        view.settings.aa = 1;
        return paint(view, SKETCH_SIZE);
    }
    static bool on_software() { return stage().device().is_software(); }
};

} // namespace

/// By itself, so that the tests beside each other find the scene and do not all make it.
TEST(DefaultScene, is_there) { EXPECT_TRUE(fs::is_regular_file(default_terrain(make_earth().radius))); }

TEST_P(Golden, is_unchanged_and_would_notice) {
    constexpr char const* UPDATE = "ALPENGLOW_UPDATE_GOLDENS=1 ./test -R golden -V";
    std::string const name = GetParam();
    View const view = load_view(view_file(name));
    ByteImage const picture = paint(view);
    if (std::getenv("ALPENGLOW_UPDATE_GOLDENS")) update(name, picture);
    if (!fs::exists(reference_file(name))) {
        write_png(report_file(name, ""), picture);
        FAIL() << "no reference yet; look at " << report_file(name, "") << ", then run: " << UPDATE;
    }
    ByteImage const reference = read_picture(reference_file(name));
    ASSERT_EQ(reference.extent, SIZE) << "make the references anew: " << UPDATE;
    Tolerance const tolerance = on_software() ? ON_SOFTWARE : ON_A_GPU;
    ByteDifference const difference = compare(picture, reference, tolerance.largest);
    EXPECT_LE(difference.share_above, tolerance.share)
        << "up to " << difference.largest << "/255 at " << difference.x << "," << difference.y << "; " << report(name, picture, reference)
        << "; where the change is meant: " << UPDATE;
    auto const share_off = [&](ByteImage const& wrong, ByteImage const& right) {
        return compare(wrong, right, tolerance.largest).share_above;
    };
    if (on_software()) { // the edges of a dark view are too few for the wide tolerance
        EXPECT_GT(share_off(shifted_by_a_pixel(picture), reference), tolerance.share) << "a shift by a pixel would pass";
    }
    ByteImage const right = sketch(view);
    for (Wrong const wrong : must_notice(name)) {
        EXPECT_GT(share_off(sketch(wrong_view(view, wrong)), right), tolerance.share) << "a picture " << words(wrong) << " would pass";
    }
}

INSTANTIATE_TEST_SUITE_P(Views, Golden, testing::ValuesIn(view_names()), [](auto const& row) { return row.param; });
