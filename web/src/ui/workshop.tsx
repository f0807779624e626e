// The studio under its head line: what is said, the avatar, the library, the timeline, and their dialogs.
import {Timeline} from "../timeline/timeline.tsx";
import {FilmDialog} from "./film_dialog.tsx";
import {Help} from "./help.tsx";
import {Inspector} from "./inspector.tsx";
import {LibraryPanel} from "./library_panel.tsx";
import {OptionsDialog} from "./options_dialog.tsx";
import {OwnGestureDialog} from "./own_gesture_dialog.tsx";
import {ConflictDialog, ProjectsDialog} from "./projects_dialog.tsx";
import {RulesDialog} from "./rules_dialog.tsx";
import {Messages} from "./messages_view.tsx";
import {SpeechPanel} from "./speech_panel.tsx";
import {Stage} from "./stage.tsx";

export function Workshop() {
  return <>
    <main class="workshop">
      <div class="left-column">
        <SpeechPanel />
        <Inspector />
      </div>
      <Stage />
      <LibraryPanel />
      <Timeline />
      <Messages />
    </main>
    <OwnGestureDialog />
    <RulesDialog />
    <OptionsDialog />
    <ProjectsDialog />
    <ConflictDialog />
    <FilmDialog />
    <Help />
  </>;
}
