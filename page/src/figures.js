// node figures.js [--in-page] [--width PX] [--font NAME] [--seconds N] [--megabytes N] OUT_DIR FILE.vl.json...: draws each
// specification as OUT_DIR/FILE.svg (draw_figure.js). --in-page: for a page that has title and caption next to it, on its own
// ground. --width: in CSS pixels, which are 1/96 of an inch. A foreign specification may ask for endless work: figures are
// drawn on another thread, which may take --seconds for each and --megabytes of memory.
import { parseArgs } from "node:util";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";

const { values: chosen, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    "in-page": { type: "boolean" },
    width: { type: "string" },
    font: { type: "string" },
    seconds: { type: "string", default: "120" },
    megabytes: { type: "string", default: "2048" },
  },
});
const [folder, ...files] = positionals;
const most = { seconds: Number(chosen.seconds), megabytes: Number(chosen.megabytes) };
// A thread that comes to its own limit may end the process without a word: the limit of all memory is met long before.
const resourceLimits = { maxOldGenerationSizeMb: 4 * most.megabytes };

function complain(file, reason) {
  console.error(`${file}: ${reason}`);
  process.exitCode = 1;
}

/** Draws figures in turn on a thread of their own. @return those behind the one that ended it */
function drawInTurn(files) {
  return new Promise((resolve) => {
    const drawer = new Worker(new URL(import.meta.url), { argv: process.argv.slice(2), workerData: files, resourceLimits });
    let done = 0, since = Date.now();
    const end = async (reason) => {
      clearInterval(watch);
      drawer.removeAllListeners();
      await drawer.terminate(); // and its memory is free
      if (done < files.length) complain(files[done], reason);
      resolve(files.slice(done + 1));
    };
    const watch = setInterval(() => {
      const seconds = (Date.now() - since) / 1000, megabytes = process.memoryUsage.rss() / 2 ** 20;
      if (megabytes > most.megabytes) end(`needs more than ${most.megabytes} MB to be drawn; reduce the rows of its data`);
      else if (seconds > most.seconds) end(`takes more than ${most.seconds} s to be drawn; simplify it`);
    }, 50);
    drawer.on("message", (problem) => {
      if (problem) complain(files[done], problem);
      ++done;
      since = Date.now();
    });
    drawer.on("error", (error) => end(error.message));
    drawer.on("exit", () => end("its drawing ended early"));
  });
}

if (isMainThread) {
  for (let rest = files; rest.length; ) rest = await drawInTurn(rest);
} else {
  const { draw } = await import("./draw_figure.js");
  for (const file of workerData) {
    let problem;
    try {
      await draw(file, folder, chosen);
    } catch (error) {
      problem = error.message;
    }
    parentPort.postMessage(problem);
  }
}
