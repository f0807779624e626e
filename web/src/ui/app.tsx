// The page: the studio, or a session in it.
import {inSession} from "../session/begin.ts";
import {SessionView} from "../session/session_view.tsx";
import {Header} from "./header.tsx";
import {Workshop} from "./workshop.tsx";

export function App() {
  if (inSession.value) return <SessionView />;
  return <>
    <Header />
    <Workshop />
  </>;
}
