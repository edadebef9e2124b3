#include "commands.h"
#include "plan_job.h"

namespace stepmill {

void addPlanCommand(CLI::App& app, int& exit_code) {
    CLI::App* plan = app.add_subcommand(
        "plan", "Plan a STEP part and write plan.json, report.html, setup sheets and programs");
    auto options = std::make_shared<PlanOptions>();
    addJobOptions(*plan, *options, "-plan");
    addFinishOptions(*plan, *options);
    addOfferOptions(*plan, *options);
    plan->add_option("--quantity", options->quantity, "pieces of the lot, among which setting up is shared")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    plan->footer(
        "Examples:\n"
        "  stepmill plan bracket.step\n"
        "  stepmill plan bracket.step --setup +z --setup -z\n"
        "  stepmill plan bracket.step --no-setup -z --no-setup -x\n"
        "  stepmill plan bracket.step -o job42 --setup +z --stock-margin 2,1,0 --material steel\n"
        "  stepmill plan bracket.step --finish-walls 0.3 --finish-floors 0.2\n"
        "  stepmill plan cavity.step --scallop 0.05\n"
        "  stepmill plan bracket.step --break-edges 0.3 --tools samples/shop_with_forms_tools.json\n"
        "  stepmill plan bracket.step --tools my_tools.json --machine my_mill.json --objective cost\n"
        "  stepmill plan bracket.step --buy catalogue.json\n"
        "  stepmill plan bracket.step --material steel --library-feeds\n"
        "  stepmill plan bracket.step --fixtures clamps.json\n"
        "  stepmill plan bracket.step --holes threads.json\n"
        "  stepmill plan bracket.step --job job42.json --display inch --pdf\n"
        "  stepmill plan bracket.step --no-viewer");
    plan->callback([options, &exit_code] { exit_code = runPlan(*options); });
}

}  // namespace stepmill
