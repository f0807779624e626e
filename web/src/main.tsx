// The studio's page begins here.
import {render} from "preact";
import {startPlayer} from "./playback/player.ts";
import {keepJournal} from "./state/journal.ts";
import {watchHomes} from "./state/homes.ts";
import {loadLibrary} from "./state/library.ts";
import {say} from "./state/messages.ts";
import {askServer, served} from "./state/server.ts";
import {startPointing} from "./state/stage.ts";
import {beginSession} from "./session/begin.ts";
import {App} from "./ui/app.tsx";
import {startShortcuts} from "./ui/shortcuts.ts";

// A session is followed; the studio keeps its journal. Until the server has said which it is, nothing is drawn for a while.
const patience_ms = 1000;
function begin(): void {
  if (served.value?.session) {
    beginSession(served.value.session);
    return;
  }
  watchHomes();
  void keepJournal().then(before => { if (before) say("Your work is as you left it."); });
}

const asked = askServer().then(begin);
await Promise.race([asked, new Promise(resolve => setTimeout(resolve, patience_ms))]);
render(<App />, document.getElementById("studio")!);
startPlayer();
startShortcuts();
startPointing();
void loadLibrary();
