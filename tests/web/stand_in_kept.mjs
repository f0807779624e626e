// What the stand-in keeps, in memory: gestures of one's own, rules, projects, each refused as the contract refuses them.
export class Refusal extends Error { constructor(field, message, status = 400) { super(message); this.field = field; this.status = status; } }

const listed = ["GET /v1/health", "POST /v1/generate", "POST /v1/speech", "GET /v1/speech/{id}.wav", "GET /v1/motions", "POST /v1/motions", "POST /v1/motions/read",
  "DELETE /v1/motions/{id}", "GET /v1/rules", "PUT /v1/rules", "GET /v1/projects", "POST /v1/projects", "GET /v1/projects/{id}",
  "PUT /v1/projects/{id}", "DELETE /v1/projects/{id}", "POST /v1/point", "POST /v1/tracks", "POST /v1/export", "GET /v1/openapi.json"];

export function openapi() {
  const paths = {};
  for (const [method, path] of listed.map(route => route.split(" "))) (paths[path] ??= {})[method.toLowerCase()] = {};
  return {openapi: "3.1.0", paths};
}

export function keeping(shipped, pointed) {
  const own = [];
  let rules = {rules: [], revision: "r0"};
  const projects = new Map();
  let number = 0;
  const motions = () => [...shipped, ...own];
  const projectOf = id => projects.get(id) ?? (() => { throw new Refusal(null, "there is no such project", 404); })();
  const current = (kept, revision) => {
    if (revision === undefined) throw new Refusal(null, "If-Match is missing", 428);
    if (revision.replaceAll('"', "") !== kept) throw new Refusal(null, "somebody else has saved meanwhile", 412);
  };

  const routes = {
    "GET /v1/motions": () => [200, {motions: motions()}],
    "POST /v1/motions": ({name, meaning = "", frames}) => {
      if (motions().some(one => one.name === name)) throw new Refusal("name", `there is a gesture called ${name} already`, 409);
      if (frames.length > 300) throw new Refusal("frames", "are more than 300", 400);
      const made = {id: `own${++number}`, name, meaning, class: "own", fps: 15, own: true, frames};
      own.push(made);
      return [201, made];
    },
    "DELETE /v1/motions/": (_, id) => {
      const at = own.findIndex(one => one.id === id);
      if (at < 0) throw shipped.some(one => one.id === id) ? new Refusal(null, "it is shipped", 403) : new Refusal(null, "there is no such gesture", 404);
      own.splice(at, 1);
      return [204, null];
    },
    "GET /v1/rules": () => [200, rules],
    "PUT /v1/rules": (asked, _, revision) => {
      if (revision !== undefined) current(rules.revision, revision);
      asked.rules.forEach((rule, k) => rule.motions.forEach((id, i) => {
        if (!motions().some(one => one.id === id)) throw new Refusal(`rules[${k}].motions[${i}]`, "there is no such gesture");
      }));
      rules = {rules: asked.rules, revision: `r${++number}`};
      return [200, rules];
    },
    "GET /v1/projects": () => [200, {projects: [...projects.values()].map(({project, ...rest}) => ({...rest, bytes: JSON.stringify(project).length})).reverse()}],
    "POST /v1/projects": ({name, project}) => {
      const one = {id: `p${++number}`, name, project, saved: new Date().toISOString(), revision: `r${number}`};
      projects.set(one.id, one);
      return [201, {id: one.id, revision: one.revision}];
    },
    "GET /v1/projects/": (_, id) => [200, projectOf(id)],
    "PUT /v1/projects/": ({name, project}, id, revision) => {
      const one = projectOf(id);
      current(one.revision, revision);
      Object.assign(one, {name, project, saved: new Date().toISOString(), revision: `r${++number}`});
      return [200, {revision: one.revision}];
    },
    "DELETE /v1/projects/": (_, id) => {
      projectOf(id);
      projects.delete(id);
      return [204, null];
    },
    "POST /v1/point": asked => [200, pointed(asked)],
    "GET /v1/openapi.json": () => [200, openapi()],
  };

  // [status, body], or null where it is no route of these.
  return (method, address, asked, revision) => {
    const [, path, id] = /^(\/v1\/[a-z.]+)(?:\/(\w+))?$/.exec(address) ?? [];
    const route = routes[`${method} ${path}${id === undefined ? "" : "/"}`];
    return route ? route(asked, id, revision) : null;
  };
}
