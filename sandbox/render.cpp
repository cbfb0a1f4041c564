#include "core/files.h"
#include "core/progress.h"
#include "image/codec.h"
#include "image/contact_sheet.h"
#include "image/exr.h"
#include "sandbox/commands.h"
#include "sandbox/stage.h"

#include <fmt/format.h>

namespace alpenglow {

int render(RenderOptions const& options) {
    // What is wrong with any view is said before the first is drawn.
    std::vector<View> views;
    for (std::filesystem::path const& file : options.views) views.push_back(load_view(file));
    require_writable_folder(options.out);

    Stage stage(options);
    ContactSheet sheet(views.size(), options.size);
    Progress progress("rendering", views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        progress.update(i, views[i].name);
        View const view = stage.dressed(views[i]);
        World const world = stage.prepare(view);
        stage.draw(view, world, options.size);
        if (options.png) {
            ByteImage const picture = stage.renderer().picture();
            write_png(options.out / (view.name + ".png"), picture);
            sheet.add(picture, view.name);
        }
        if (options.exr) write_exr(options.out / (view.name + ".exr"), stage.renderer().radiance());
    }
    if (options.png && views.size() > 1) write_png(options.out / "contact_sheet.png", sheet.picture());
    progress.update(views.size());
    stage.require_no_messages();
    fmt::print("{}\n", options.out.string());
    return 0;
}

} // namespace alpenglow
