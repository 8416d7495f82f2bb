// What the page requests of its server: forms in, JSON out.

/** Without the folders in which the server keeps what was dropped: "curve/dam.csv:3" -> "dam.csv:3". */
export const plain = (text) => text.replace(/(^|[\s`])(?:curve|filter|record)\/(?=[\w.-])/g, "$1");

/** An answer that is an error: what the program replied, and the problems with their lines. */
export class Refused extends Error {
  constructor(status, error, talk) {
    super(plain(error?.message ?? "the studio does not answer"));
    this.status = status;
    this.problems = (error?.problems ?? []).map((problem) => ({ ...problem, message: plain(problem.message) }));
    this.instead = error?.instead; // what can be simulated in place of a soil that is too wide
    this.talk = talk ?? [];
  }
}

async function answerOf(request) {
  let response, reply;
  try {
    response = await request;
    reply = await response.json();
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refused(0, { message: "The studio does not answer. Was it ended? Start suffuse studio again; runs go on without it." });
  }
  const talk = reply.talk?.map(plain);
  if (!response.ok) throw new Refused(response.status, reply.error, talk);
  return { ...reply, talk };
}

export const get = (path) => answerOf(fetch(path));

/** @param fields texts, files, or { name, blob }; what is empty is left out */
export function post(path, fields = {}, signal = undefined) {
  const form = new FormData();
  form.append("from-page", "studio");
  for (const [name, value] of Object.entries(fields)) {
    if (value === undefined || value === null || value === "") continue;
    if (value.blob) form.append(name, value.blob, value.name);
    else form.append(name, value);
  }
  return answerOf(fetch(path, { method: "POST", body: form, signal }));
}

/** Calls `act` some time after the last change; an answer that comes after the next change is dropped. */
export function afterChanges(milliseconds, act) {
  let timer, current;
  return () => {
    clearTimeout(timer);
    current?.abort();
    timer = setTimeout(async () => {
      current = new AbortController();
      try {
        await act(current.signal);
      } catch (error) {
        if (error.name !== "AbortError") throw error;
      }
    }, milliseconds);
  };
}

export const runPath = (name) => `/api/runs/${encodeURIComponent(name)}`;
