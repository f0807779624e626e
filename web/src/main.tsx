// The studio's page begins here.
import {render} from "preact";
import {startPlayer} from "./playback/player.ts";
import {keepJournal} from "./state/journal.ts";
import {watchHomes} from "./state/homes.ts";
import {loadLibrary} from "./state/library.ts";
import {say} from "./state/messages.ts";
import {askServer} from "./state/server.ts";
import {startPointing} from "./state/stage.ts";
import {App} from "./ui/app.tsx";
import {startShortcuts} from "./ui/shortcuts.ts";

render(<App />, document.getElementById("studio")!);
startPlayer();
startShortcuts();
startPointing();
watchHomes();
void keepJournal().then(before => { if (before) say("Your work is as you left it."); });
void askServer();
void loadLibrary();
