#include "commands.h"
#include "plan_job.h"

namespace stepmill {

void addRoughCommand(CLI::App& app, int& exit_code) {
    CLI::App* rough = app.add_subcommand(
        "rough", "Plan the roughing of a STEP part alone: a die, a mold, a casting; an allowance stays");
    auto options = std::make_shared<PlanOptions>();
    options->rough = true;
    addJobOptions(*rough, *options, "-rough");
    // It makes no hole to size, and leaves nothing to later setups but what they rough.
    for (const char* none : {"--holes", "--no-reserve"})
        rough->remove_option(rough->get_option(none));
    rough
        ->add_option("--allowance", options->allowance_mm,
                     "mm that stay on walls, and on floors; 0: the last pass makes size")
        ->capture_default_str();
    rough->add_option("--floor-allowance", options->floor_allowance_mm,
                      "mm that stay on floors, where that is not what stays on walls");
    rough->footer(
        "The allowance and the stairs on walls that lean stay as they should: with nothing else left the "
        "exit "
        "code is 0.\n"
        "Examples:\n"
        "  stepmill rough die.step\n"
        "  stepmill rough die.step --allowance 0.3 --floor-allowance 0.2 --material steel\n"
        "  stepmill rough core.step --setup +z --stock core_blank.step -o core-roughing");
    rough->callback([options, &exit_code] { exit_code = runPlan(*options); });
}

}  // namespace stepmill
