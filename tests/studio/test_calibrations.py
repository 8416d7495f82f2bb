"""Calibrations in `suffuse studio`: read, checked, priced, run, stopped, resumed, listed, deleted: test_calibrations.py PROGRAM."""
import json
import math

from studio_process import InAFolder, main

CASE = """schema = 1
title = "few grains"
seed = 2
[grain]
density = "2650 kg/m^3"
[contact]
shear_ratio = 0.42
rolling_stiffness = 7.5
rolling_friction = 0.2
[soil.sand]
psd = { d = ["0.13 mm", "0.14 mm", "0.15 mm"], passing = ["0 %", "50 %", "100 %"] }
[calibrate]
soil = "sand"
particles = 120
samples = 16
[[calibrate.targets]]
name = "t"
file = "data/t.csv"
pressure = "100 kPa"
strain = 0.01
contraction = "positive"
void_ratio_tolerance = 0.03
[calibrate.unknowns]
"contact.modulus" = ["100 MPa", "1 GPa", "log"]
"contact.friction" = ["20 deg", "40 deg"]
void_ratio = [0.6, 0.75]
"""
RECORD = "axial strain [%],q [kPa],volumetric strain [%]\n" + "".join(
    f"{0.1 * k:.1f},{200 * (1 - math.exp(-0.4 * k))},{0.01 * k}\n" for k in range(21))


def case(text=CASE):
    return {"name": "Sand fit", "case": text, "file:data/t.csv": RECORD}


class Calibrations(InAFolder):
    def started(self, studio, **more):
        answer = studio.post("/api/start", {**case(), **more})
        self.assertEqual(answer.status, 201, answer.text)
        return json.loads(answer.text)["run"]

    def ended(self, studio, name):
        self.wait("the calibration ends", lambda: not studio.get_json(f"/api/runs/{name}")["at_work"])
        return studio.get_json(f"/api/runs/{name}")

    def test_a_record_is_read_as_the_program_reads_it(self):
        studio = self.studio()
        read = json.loads(studio.post("/api/record", {"record": ("t.csv", RECORD), "kind": "triaxial", "contraction": "positive"}).text)["result"]
        self.assertEqual([column["role"] for column in read["columns"]], ["axial_strain", "deviator_stress", "volumetric_strain"])
        self.assertEqual(len(read["tests"]), 1)
        self.assertEqual(read["tests"][0]["first"]["deviator_stress"], 0)
        self.assertAlmostEqual(read["tests"][0]["last"]["axial_strain"], 0.02)
        self.assertEqual(studio.post("/api/record", {"record": ("t.csv", "a,b\n1,2\n"), "kind": "triaxial"}).status, 422)
        self.assertEqual(studio.post("/api/record", {"record": ("t.csv", RECORD), "kind": "--output=x"}).status, 422)
        self.assertEqual(studio.post("/api/record", {"kind": "triaxial"}).status, 400)
        self.assertEqual(studio.post("/api/record", {"record": ("t.csv", RECORD)}, cookie=False).status, 401)

    def test_it_is_priced_by_its_samples_and_errors_have_their_lines(self):
        studio = self.studio()
        self.assertEqual(json.loads(studio.post("/api/check", case()).text)["result"]["problems"][0]["code"], "W602")
        plan = json.loads(studio.post("/api/plan", case()).text)["result"]
        self.assertEqual((plan["samples"], plan["first_round"]["studies"]), (16, 12))
        for wrong, line in (("rolling_frictoin = 0.2", 9), ('"contact.frictoin" = ["20 deg", "40 deg"]', 25), ('pressure = "100 kg"', 19)):
            right = {9: "rolling_friction = 0.2", 25: '"contact.friction" = ["20 deg", "40 deg"]', 19: 'pressure = "100 kPa"'}[line]
            answer = studio.post("/api/check", case(CASE.replace(right, wrong)))
            self.assertEqual(answer.status, 422)
            self.assertIn(line, [problem["line"] for problem in json.loads(answer.text)["error"]["problems"]], wrong)
            self.assertEqual(studio.post("/api/start", case(CASE.replace(right, wrong))).status, 422)
        self.assertEqual(studio.get_json("/api/names")["result"], [])

    def test_it_is_an_ordinary_folder_whose_report_is_there_at_its_end(self):
        studio = self.studio()
        name = self.started(studio)
        run = self.ended(studio, name)
        self.assertEqual(run["events"][-1]["outcome"], "done")
        rounds = run["calibration"]["rounds"]
        self.assertEqual((rounds[0]["name"], rounds[0]["stages"], rounds[0]["done"]), ("round-1", 36, 36))
        self.assertTrue(run["report"] and run["can_delete"] and run["calibration"]["answered"])
        answer = studio.get_json(f"/runs/{name}/calibration.json")
        self.assertTrue(answer["complete"])
        self.assertEqual(len(answer["samples"]), sum(round["samples"] for round in answer["rounds"]))
        self.assertEqual(set(answer["rounds"][0]["parameters"]), set(answer["parameters"]))
        listed = studio.get_json("/api/runs")["result"]["runs"]
        self.assertEqual([(run["name"], run["kind"], run["state"], run["verdict"]) for run in listed], [(name, "calibration", "done", answer["verdict"])])
        self.assertEqual(studio.get_json("/api/names")["result"], [name])
        page = studio.get(f"/runs/{name}/report.html").text.decode()
        self.assertIn("own-calibration-corner", page)
        written = (self.runs / name / "report.html").read_bytes()
        (self.runs / name / "report.html").unlink()
        self.suffuse("report", f"runs/{name}")
        self.assertEqual((self.runs / name / "report.html").read_bytes().count(b"<figure"), written.count(b"<figure"))
        self.assertEqual(studio.post(f"/api/runs/{name}/delete").status, 200)
        self.assertFalse((self.runs / name).exists())

    def test_it_is_stopped_with_its_state_and_resumed_to_the_same_answer(self):
        studio = self.studio()
        first = self.started(studio, **{"time-limit": "1ms"})
        run = self.ended(studio, first)
        self.assertIsNone(run["calibration"]["answered"])
        self.assertTrue(run["can_delete"], "it has ended, and says by what it was made")
        self.assertEqual([run["state"] for run in studio.get_json("/api/runs")["result"]["runs"]], ["not complete"])
        self.assertEqual(studio.post(f"/api/runs/{first}/resume").status, 201)
        self.ended(studio, first)
        second = self.started(studio)
        stop = studio.post(f"/api/runs/{second}/stop")
        self.assertIn(stop.status, (202, 409))  # the cache may have let it end before
        if not (self.runs / second / "calibration.json").exists() or not studio.get_json(f"/runs/{second}/calibration.json")["complete"]:
            self.ended(studio, second)
            studio.post(f"/api/runs/{second}/resume")
        self.ended(studio, second)
        answers = [studio.get_json(f"/runs/{name}/calibration.json") for name in (first, second)]
        self.assertTrue(answers[0]["complete"])
        for key in ("parameters", "correlation", "rounds", "samples"):
            self.assertEqual(answers[0][key], answers[1][key], key)
        compared = studio.get_json(f"/api/compare/{first}/{second}")["result"]
        self.assertEqual((compared["differences"], compared["numbers"]), ([], 11))

    def test_one_that_is_killed_between_two_rounds_goes_on(self):
        studio = self.studio()
        name = self.started(studio)
        self.ended(studio, name)
        run = self.runs / name
        answer = json.loads((run / "calibration.json").read_text())
        (run / "calibration.json").write_text(json.dumps({**answer, "complete": False}))  # as after its last round but one
        self.assertEqual([run["state"] for run in studio.get_json("/api/runs")["result"]["runs"]], ["not complete"])
        self.assertEqual(studio.post(f"/api/runs/{name}/resume").status, 201)
        self.ended(studio, name)
        self.assertEqual(json.loads((run / "calibration.json").read_text()), answer)

    def test_what_only_looks_like_a_calibration_stays_out_of_reach(self):
        studio = self.studio()
        secret = self.folder / "secret"
        secret.mkdir()
        (secret / "calibrate.toml").write_text(CASE)
        (self.runs / "linked").symlink_to(secret)
        self.assertEqual(studio.get("/api/runs/linked").status, 404)
        self.assertEqual(studio.get("/runs/linked/calibrate.toml").status, 404)
        self.assertEqual(studio.post("/api/runs/linked/delete").status, 404)
        (self.runs / "hand-made").mkdir()
        (self.runs / "hand-made" / "calibrate.toml").write_text(CASE)
        self.assertEqual(studio.post("/api/runs/hand-made/delete").status, 403)
        self.assertTrue((self.runs / "hand-made" / "calibrate.toml").exists())


if __name__ == "__main__":
    main()
