#include "image/codec.h"
#include "scene/gltf_contents.h"
#include "scene/gltf_resources.h"
#include "scene/gltf_structure.h"
#include "scene/gltf_uri.h"

#include <cstring>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

/// The media type that the first bytes tell; "" for none that is known.
std::string_view recognized(std::vector<std::byte> const& bytes) {
    auto const has = [&](std::size_t offset, std::string_view magic) {
        return bytes.size() >= offset + magic.size() &&
               std::memcmp(bytes.data() + offset, magic.data(), magic.size()) == 0;
    };
    if (has(0, "\x89PNG")) return "image/png";
    if (has(0, "\xFF\xD8\xFF")) return "image/jpeg";
    if (has(0, "RIFF") && has(8, "WEBP")) return "image/webp";
    if (has(0, "\xABKTX 20")) return "image/ktx2";
    return "";
}

void check_header(std::vector<std::byte> const& bytes, std::string_view type, std::string const& pointer,
                  Report& report) {
    constexpr std::size_t png_header = 33; // signature and first chunk
    if (type == "image/png" && bytes.size() < png_header)
        return report.warn("IMAGE_UNEXPECTED_EOS", pointer, "ends in the picture's header");
    if (type != "image/png" && type != "image/jpeg") return;
    try {
        read_picture_header(bytes);
    } catch (Error const& error) {
        report.warn("IMAGE_DATA_INVALID", pointer, error.what());
    }
}

class ImageCheck {
public:
    ImageCheck(Json const& json, Document const& document, Report& report) : document_(document), report_(report) {
        for (Json const& name : member(json, "extensionsUsed")) webp_ = webp_ || name == "EXT_texture_webp";
    }

    /// Returns the declared media type, or the recognized one where none is declared.
    std::string check(std::size_t index, Json const& image, std::string const& pointer) {
        std::string declared = image.value("mimeType", std::string(data_uri_type(image.value("uri", ""))));
        std::vector<std::byte> bytes;
        try {
            bytes = read_image_bytes(document_, index, report_);
        } catch (GltfError const& error) {
            // Whether that matters is seen where a material uses it.
            report_.warn(error.diagnostic());
            return declared;
        }
        std::string_view const type = recognized(bytes);
        if (type.empty()) report_.say("IMAGE_UNRECOGNIZED_FORMAT", pointer, "is no PNG, JPEG, WebP or KTX2");
        if (declared.empty()) declared = type;
        if (type != "" && type != declared)
            report_.say("IMAGE_MIME_TYPE_INVALID", pointer, fmt::format("is {}, not {}", type, printable(declared)));
        if (type == "image/webp" && !webp_)
            report_.say("IMAGE_NON_ENABLED_MIME_TYPE", pointer, "is WebP, which needs EXT_texture_webp");
        check_header(bytes, type, pointer, report_);
        return declared;
    }

private:
    Document const& document_;
    Report& report_;
    bool webp_ = false;
};

} // namespace

void check_images(Json const& json, Document const& document, Report& report) {
    ImageCheck check(json, document, report);
    std::vector<std::string> types;
    for_each(json, "images", "", [&](Json const& image, std::string const& pointer) {
        types.push_back(check.check(types.size(), image, pointer));
    });
    for_each(json, "textures", "", [&](Json const& texture, std::string const& pointer) {
        Json const& source = member(texture, "source");
        if (!source.is_null() && types[source.get<std::size_t>()] == "image/webp")
            report.say("TEXTURE_INVALID_IMAGE_MIME_TYPE", pointer + "/source", "is WebP without EXT_texture_webp");
    });
}

} // namespace alpenglow::gltf
