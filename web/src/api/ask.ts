// How the server is asked, and what is told where it refuses or does not answer.

// `field`: what of the request was wrong, where the server says so.
export class ServerError extends Error {
  readonly status: number;
  readonly field: string | null;
  constructor(message: string, status: number, field: string | null) {
    super(message);
    this.status = status;
    this.field = field;
  }
}

export async function ask(path: string, request: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, {...request, credentials: "same-origin"});
  } catch {
    throw new ServerError("The server does not answer: does the program (deixis) still run? Nothing of your work is lost.", 0, null);
  }
  if (response.ok) return response;
  if (response.status === 401)
    throw new ServerError("This page may no longer speak to the server. Open the address that the program printed.", 401, null);
  const answer = await response.json().catch(() => null) as {error?: {message?: string; field?: string | null}} | null;
  throw new ServerError(answer?.error?.message ?? `The server answered ${response.status} to ${path}.`, response.status, answer?.error?.field ?? null);
}

// `revision`: what the change is made to; where the server has another one meanwhile, it refuses with 412.
export const send = (method: "POST" | "PUT", path: string, body: unknown, revision: string | null = null): Promise<Response> =>
    ask(path, {method, headers: {"Content-Type": "application/json", ...(revision !== null && {"If-Match": `"${revision}"`})}, body: JSON.stringify(body)});

export const post = (path: string, body: unknown): Promise<Response> => send("POST", path, body);

export function check(holds: boolean, path: string, what: string): void {
  if (!holds) throw new ServerError(`The server's answer to ${path} lacks ${what}: page and server are of different versions.`, 0, null);
}

export const wordsOf = (problem: unknown): string => problem instanceof Error ? problem.message : String(problem);
