// Files in the server's folder that cannot be read.
import type {Damaged} from "../api/client.ts";

export function DamagedNote({damaged}: {damaged: readonly Damaged[]}) {
  if (damaged.length === 0) return null;
  return <ul class="damaged">{damaged.map(({file, problem}) => <li key={file}>{file} cannot be read: {problem}</li>)}</ul>;
}
