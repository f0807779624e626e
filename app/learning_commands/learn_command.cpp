// deixis learn: what systems are learned from, and learning them.
#include "app/learning_commands/learning_commands.hpp"
#include "app/program/command_help.hpp"
#include "learn_commands.hpp"

namespace deixis::app {

void addLearnCommand(Parser cli, Command& chosen) {
    Parser learn = cli.addCommand("learn", "Prepare demonstrations, and train systems on them");
    learn.requireCommand();
    describe(learn, {.writes = "what -o names.",
                     .example = "deixis learn project clips/manifest.csv -o projected",
                     .page = "docs/learning.md"});
    addLearnProjectCommand(learn, chosen);
    addLearnTrainCommands(learn, chosen);
#ifdef DEIXIS_STUDIO
    addLearnGesturesCommands(learn, chosen);
#endif
}

}  // namespace deixis::app
