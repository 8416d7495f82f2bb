"""Sweeps in `suffuse studio`: priced, run, compared, and as tasks of a cluster: test_sweeps.py PROGRAM [unittest's words]."""
import json
import shutil
import subprocess

from studio_process import InAFolder, main


class Sweeps(InAFolder):
    LINE = 'sweep = { "contact.friction" = ["20 deg", "35 deg"] }'

    def case(self, studio, line=LINE):
        made = json.loads(studio.post("/api/new", {"from": "replay"}).text)["result"]
        text = made["case"].replace("[study.replay]\n", f"[study.replay]\n{line}\n")
        self.assertIn(line, text)
        return {"name": "Friction", "case": text, **{"file:" + name: text for name, text in made["files"].items()}}

    def swept(self, studio):
        started = studio.post("/api/start", self.case(studio))
        self.assertEqual(started.status, 201, started.text)
        name = json.loads(started.text)["run"]
        self.wait("the sweep ends", lambda: not studio.get_json(f"/api/runs/{name}")["at_work"])
        return name

    def test_a_sweep_is_priced_by_its_samples_and_is_an_ordinary_run(self):
        studio = self.studio()
        plan = json.loads(studio.post("/api/plan", self.case(studio)).text)["result"]
        samples = ["replay/friction=20deg", "replay/friction=35deg"]
        self.assertEqual([sample["sample"] for sample in plan["samples"]], samples)
        name = self.swept(studio)
        self.suffuse("verify", f"runs/{name}")
        done = studio.get_json(f"/api/runs/{name}")["done"]
        self.assertEqual(done, sorted(f"{sample}/{stage}" for sample in samples for stage in ("start", "settled", "compressed", "seep")))
        for stage in done:
            numbers = studio.get_json(f"/runs/{name}/studies/{stage}/stage.json")
            self.assertEqual(f"{numbers['sample']}/{numbers['stage']}", stage)

    def test_every_number_of_the_table_has_the_unit_that_the_program_gives(self):
        units = {fact["key"]: fact["unit"] for fact in self.studio().get_json("/api/results")["result"]["results"]}
        self.assertEqual((units["void_ratio"], units["mean_stress"], units["friction_angle"]), ("-", "Pa", "rad"))

    def test_an_error_of_a_swept_value_has_its_line_and_leaves_nothing(self):
        studio = self.studio()
        case = self.case(studio, 'sweep = { "contact.friction" = ["20 deg", "35 dg"] }')
        at = case["case"].splitlines().index('sweep = { "contact.friction" = ["20 deg", "35 dg"] }') + 1
        for path in ("/api/check", "/api/plan", "/api/start", "/api/slurm"):
            answer = studio.post(path, case)
            self.assertEqual(answer.status, 422, answer.text)
            self.assertIn(at, [p["line"] for p in json.loads(answer.text)["error"]["problems"]], path)
        self.assertEqual(studio.get_json("/api/names")["result"], [])
        self.assertEqual([path.name for path in self.runs.iterdir() if path.name != "suffuse-cache"], [])

    def test_tasks_for_a_cluster_are_those_of_the_program_and_are_gathered(self):
        studio = self.studio()
        answer = studio.post("/api/slurm", {**self.case(studio), "threads": "2", "time-limit": "1h"})
        self.assertEqual(answer.status, 201, answer.text)
        written = json.loads(answer.text)
        run = self.runs / written["run"]
        self.assertEqual((written["run"], written["tasks"]), ("friction-0001", 2))
        self.assertEqual(written["script"], (run / "sweep.sbatch").read_text())
        self.assertIn("#SBATCH --array=1-2", written["script"])
        self.assertIn("#SBATCH --cpus-per-task=2", written["script"])
        path = f"/api/runs/{written['run']}"
        self.assertTrue(studio.get_json(path)["tasks"])
        first, second = (run / "tasks.txt").read_text().splitlines()
        subprocess.run(first, shell=True, check=True, capture_output=True)
        self.assertEqual({stage.split("/")[1] for stage in studio.get_json(path)["done"]}, {"friction=20deg"})
        self.assertEqual(json.loads(studio.post(path + "/collect").text)["result"]["done"], 1)
        rest = json.loads(studio.post(path + "/slurm").text)
        self.assertEqual(rest["tasks"], 1)
        self.assertEqual((run / "tasks.txt").read_text().split(" -j ")[0], second.split(" -j ")[0])
        subprocess.run(second, shell=True, check=True, capture_output=True)
        gathered = json.loads(studio.post(path + "/collect").text)["result"]
        self.assertEqual((gathered["done"], gathered["unfinished"]), (2, []))
        self.assertEqual(studio.post(path + "/slurm").status, 409)

    def test_slurm_scripts_and_results_need_the_cookie_and_a_run_of_the_folder(self):
        studio = self.studio()
        case = self.case(studio)
        secret = self.folder / "secret"
        secret.mkdir()
        (self.folder / "secret" / "case.resolved.toml").write_text("")
        (self.runs / "linked").symlink_to(secret)
        self.assertEqual(studio.post("/api/slurm", case, cookie=False).status, 401)
        self.assertEqual(studio.post("/api/slurm", case, headers={"Origin": "http://evil.example"}).status, 403)
        self.assertEqual(studio.post("/api/slurm", case, headers={"Host": "evil.example"}).status, 403)
        self.assertEqual(studio.get("/api/slurm").status, 404)
        for what in ("slurm", "collect"):
            self.assertEqual(studio.post(f"/api/runs/linked/{what}").status, 404)
            self.assertEqual(studio.post(f"/api/runs/..%2Fsecret/{what}").status, 404)
            self.assertEqual(studio.get(f"/api/runs/linked/{what}").status, 404)
            self.assertEqual(studio.post(f"/api/runs/linked/{what}", cookie=False).status, 401)
        for threads in (f"2 --output={secret}/tasks", "0", "-1"):
            self.assertEqual(studio.post("/api/slurm", {**case, "threads": threads}).status, 422, threads)
        self.assertEqual(studio.post("/api/slurm", {**case, "file:../x": "1"}).status, 400)
        self.assertEqual([path.name for path in secret.iterdir()], ["case.resolved.toml"])
        self.assertEqual(studio.get_json("/api/names")["result"], [])

    def test_a_script_that_is_a_link_is_neither_written_nor_shown(self):
        studio = self.studio()
        name = self.swept(studio)
        secret = self.folder / "secret.txt"
        secret.write_text("mine")
        shutil.rmtree(self.runs / name / "studies/replay/friction=35deg/seep")  # one sample is not finished
        (self.runs / name / "sweep.sbatch").symlink_to(secret)
        self.assertFalse(studio.get_json(f"/api/runs/{name}")["tasks"])
        answer = studio.post(f"/api/runs/{name}/slurm")
        self.assertNotEqual(answer.status, 201, answer.text)
        self.assertNotIn(b"mine", answer.text)
        self.assertEqual(secret.read_text(), "mine")
        self.assertEqual(studio.get(f"/runs/{name}/sweep.sbatch").status, 404)

    def test_stages_behind_a_link_do_not_count(self):
        studio = self.studio()
        name = self.swept(studio)
        done = studio.get_json(f"/api/runs/{name}")["done"]
        elsewhere = self.folder / "elsewhere"
        (elsewhere / "stage").mkdir(parents=True)
        (elsewhere / "stage" / "stage.json").write_text("{}")
        (self.runs / name / "studies" / "linked").symlink_to(elsewhere)
        (self.runs / name / "studies" / "replay" / "linked").symlink_to(elsewhere / "stage")
        self.assertEqual(studio.get_json(f"/api/runs/{name}")["done"], done)
        self.assertEqual(studio.get(f"/runs/{name}/studies/linked/stage/stage.json").status, 404)

    def test_a_sweep_is_compared_with_another_one_and_with_a_run(self):
        run = self.finished_run()
        studio = self.studio()
        first, second = self.swept(studio), self.swept(studio)
        self.assertEqual(studio.get_json(f"/api/compare/{first}/{second}")["result"]["differences"], [])
        self.assertTrue(studio.get_json(f"/api/compare/{first}/{run}")["result"])


if __name__ == "__main__":
    main()
