// The studio's page begins here.
import {render} from "preact";
import {startPlayer} from "./playback/player.ts";
import {keepJournal} from "./state/journal.ts";
import {loadLibrary} from "./state/library.ts";
import {say} from "./state/messages.ts";
import {App} from "./ui/app.tsx";
import {startShortcuts} from "./ui/shortcuts.ts";
import {askHealth} from "./ui/speech_panel.tsx";

render(<App />, document.getElementById("studio")!);
startPlayer();
startShortcuts();
void keepJournal().then(before => { if (before) say("Your work is as you left it."); });
void askHealth();
void loadLibrary();
