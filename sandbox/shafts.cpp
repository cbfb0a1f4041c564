#include "core/progress.h"
#include "image/mask.h"
#include "sandbox/commands.h"
#include "sandbox/shaft_error.h"
#include <fmt/format.h>

namespace alpenglow {

int shafts(ShaftsOptions const& options) {
    Stage stage(options);
    for (auto const& file : options.views.empty() ? shaft_views() : options.views) {
        ShaftCase const given = make_shaft_case(stage, stage.dressed(load_view(file)), options.size);
        for (ShaftLevel const& level : shaft_levels()) {
            ShaftError const e = shaft_error(draw_shafts(stage, at_level(given.view, level), given.size), given);
            fmt::print("{:<14}{:<10} flip {:.4f} masked {:.4f} ({:.0f} %) rmse {:.2f} % p999 {:.3f}\n", given.view.name, level.name, e.flip, e.masked_flip.value_or(0), 100*share_of(given.mask), 100*e.rmse, e.p999);
            std::fflush(stdout);
        }
    }
    return 0;
}

} // namespace alpenglow
