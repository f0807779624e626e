// Asks for one thing at a time: what is wanted meanwhile is asked for next, the last of it only.
export function latest<Wanted, Answer>(ask: (wanted: Wanted) => Promise<Answer>, put: (answer: Answer, wanted: Wanted) => void,
    fail: (problem: unknown) => void = () => {}): (wanted: Wanted) => void {
  let asking = false;
  let next: {readonly wanted: Wanted} | null = null;
  const run = (wanted: Wanted): void => {
    asking = true;
    void ask(wanted).then(answer => put(answer, wanted), fail).finally(() => {
      asking = false;
      const following = next;
      next = null;
      if (following) run(following.wanted);
    });
  };
  return wanted => {
    if (asking) next = {wanted};
    else run(wanted);
  };
}
