"""`suffuse studio` as a browser and as an attacker see it: test_studio.py PROGRAM [unittest's words].

Each test starts the real program on a folder of its own and speaks HTTP to it, byte by byte where a browser would not.
"""
import concurrent.futures
import json
import pathlib
import re
import signal
import socket

from studio_process import CURVE, InAFolder, main


class Refusals(InAFolder):
    def test_nothing_is_answered_without_the_token_or_the_cookie(self):
        studio = self.studio()
        for path in ("/", "/studio.js", "/api/runs", "/api/names", "/api/keys", "/api/results", "/runs/a/report.html", "/no-such-thing", "/?token=", "/?token=" + "0" * 64):
            self.assertEqual(studio.get(path, cookie=False).status, 401, path)
        self.assertEqual(studio.post("/api/assess", cookie=False).status, 401)
        for cookie in ("", "suffuse-studio-1=" + studio.token, f"suffuse-studio-{studio.port}=" + "0" * 64,
                       f"suffuse-studio-{studio.port}=" + studio.token[:-1]):
            self.assertEqual(studio.get("/", headers={"Cookie": cookie}).status, 401, cookie)
        self.assertEqual(studio.get("/").status, 200)

    def test_the_token_is_exchanged_for_a_strict_cookie_that_scripts_cannot_read(self):
        studio = self.studio()
        answer = studio.get(f"/?token={studio.token}", cookie=False)
        self.assertEqual((answer.status, answer.headers["Location"]), (303, "/"))
        self.assertEqual(answer.headers["Set-Cookie"], f"{studio.cookie}; HttpOnly; SameSite=Strict; Path=/")

    def test_the_token_counts_in_the_address_of_the_page_alone(self):
        studio = self.studio()
        self.assertEqual(studio.get(f"/api/runs?token={studio.token}", cookie=False).status, 401)
        self.assertEqual(studio.post(f"/?token={studio.token}", cookie=False).status, 401)

    def test_a_browser_sent_from_another_page_reloads_once_by_itself(self):
        studio = self.studio()
        elsewhere = {"Sec-Fetch-Site": "cross-site"}
        answer = studio.get("/", cookie=False, headers=elsewhere)
        self.assertEqual(answer.status, 401)
        self.assertIn(b'http-equiv="refresh" content="0;url=/"', answer.text)
        wrong = studio.get("/?token=0", cookie=False, headers=elsewhere)
        self.assertNotIn(b"refresh", wrong.text)

    def test_another_name_of_this_machine_is_refused_on_every_method(self):
        studio = self.studio()
        for host in ("evil.example", f"evil.example:{studio.port}", "127.0.0.1", f"127.0.0.1:{studio.port + 1}", f"[::1]:{studio.port}", ""):
            for method in ("GET", "HEAD", "POST", "OPTIONS"):
                self.assertEqual(studio.request(method, "/", headers={"Host": host}).status, 403, (host, method))
            self.assertEqual(studio.get(f"/?token={studio.token}", headers={"Host": host}, cookie=False).status, 403)
        self.assertEqual(studio.get("/", headers={"Host": f"localhost:{studio.port}"}).status, 200)
        twice = f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\nHost: evil.example\r\nCookie: {studio.cookie}\r\n\r\n"
        self.assertIn(" 403 ", studio.raw(twice.encode()))

    def test_another_origin_is_refused_on_every_method(self):
        studio = self.studio()
        for origin in ("http://evil.example", "null", f"https://127.0.0.1:{studio.port}", f"http://127.0.0.1:{studio.port + 1}"):
            self.assertEqual(studio.get("/", headers={"Origin": origin}).status, 403, origin)
            self.assertEqual(studio.post("/api/assess", headers={"Origin": origin}).status, 403, origin)
        self.assertEqual(studio.get("/", headers={"Origin": f"http://127.0.0.1:{studio.port}"}).status, 200)

    def test_no_answer_lets_another_page_read_it(self):
        studio = self.studio()
        for answer in (studio.get("/"), studio.request("OPTIONS", "/api/assess"), studio.get("/api/runs"), studio.get("/no")):
            self.assertFalse([name for name in answer.headers if name.lower().startswith("access-control")])
            self.assertEqual(answer.headers["Cross-Origin-Resource-Policy"], "same-origin")
            self.assertEqual(answer.headers["X-Content-Type-Options"], "nosniff")
            self.assertEqual(answer.headers["Referrer-Policy"], "no-referrer")
            self.assertEqual(answer.headers["Cache-Control"], "no-store")

    def test_only_this_machine_is_listened_to(self):
        studio = self.studio()
        listening = [line.split() for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]]
        places = {row[1] for row in listening if row[3] == "0A" and int(row[1].split(":")[1], 16) == studio.port}
        self.assertEqual(places, {f"0100007F:{studio.port:04X}"})
        ipv6 = pathlib.Path("/proc/net/tcp6")
        other = [line.split()[1] for line in ipv6.read_text().splitlines()[1:]] if ipv6.exists() else []
        self.assertFalse([place for place in other if place.endswith(f":{studio.port:04X}")])

    def test_paths_out_of_the_folder_are_not_found(self):
        run = self.finished_run()
        secret = self.folder / "secret"
        secret.mkdir()
        for name in ("case.resolved.toml", "report.html"):
            (secret / name).write_text("{}")
        (self.runs / "linked").symlink_to(secret)
        (self.runs / run / "out.html").symlink_to(secret / "report.html")
        studio = self.studio()
        self.assertEqual(studio.get(f"/runs/{run}/report.html").status, 200)
        for path in ("/runs/../secret/report.html", "/runs/%2e%2e/report.html", "/runs/..%2Fsecret/report.html", "/runs/linked/report.html",
                     f"/runs/{run}/../../secret/report.html", f"/runs/{run}/%2e%2e/%2e%2e/secret/report.html", f"/runs/{run}/out.html",
                     f"/runs/{run}//etc/passwd", f"/runs/{run}/..%2F{run}/report.html/", "/runs/./report.html", f"/runs/{run}/",
                     f"/runs/{run}/studies", "/runs/suffuse-cache/cache.json", "/api/runs/linked", "/api/runs/%2e%2e", "/etc/passwd"):
            self.assertEqual(studio.get(path).status, 404, path)
        for path in ("/api/runs/linked/delete", "/api/runs/%2e%2e/delete", "/api/runs/..%2Fsecret/delete", "/api/runs/linked/stop"):
            self.assertEqual(studio.post(path).status, 404, path)
        self.assertTrue((secret / "report.html").exists())

    def test_more_than_64_megabytes_are_refused(self):
        studio = self.studio()
        head = f"POST /api/assess HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\nCookie: {studio.cookie}\r\n"
        self.assertIn(" 413 ", studio.raw((head + f"Content-Length: {(64 << 20) + 1}\r\n\r\n").encode()))
        self.assertIn(" 400 ", studio.raw((head + "Content-Length: -1\r\n\r\n").encode()))
        # What does not say its length, or unpacks to more, passes by the limit of the library.
        self.assertIn(" 411 ", studio.raw((head + "Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n").encode()))
        self.assertIn(" 411 ", studio.raw((head + "\r\n").encode()))
        self.assertIn(" 415 ", studio.raw((head + "Content-Encoding: gzip\r\nContent-Length: 1\r\n\r\n0").encode()))

    def test_pages_of_the_studio_run_no_inline_script_and_files_of_runs_have_no_rights(self):
        run = self.finished_run()
        studio = self.studio()
        own = studio.get("/").headers["Content-Security-Policy"]
        self.assertIn("default-src 'none'; script-src 'self'; style-src 'self'", own)
        self.assertIn("frame-ancestors 'none'", own)
        self.assertNotIn("unsafe", own)
        for file in ("report.html", "case.toml", "summary.json"):
            policy = studio.get(f"/runs/{run}/{file}").headers["Content-Security-Policy"]
            self.assertTrue(policy.startswith("sandbox allow-scripts allow-downloads; default-src 'none';"), policy)
            self.assertNotIn("allow-same-origin", policy)
            self.assertNotIn("connect-src", policy)

    def test_what_changes_something_is_a_post(self):
        run = self.finished_run()
        studio = self.studio()
        (self.runs / "a-link").symlink_to(self.runs / run)
        self.assertEqual(studio.get_json("/api/names")["result"], [run])
        for path in ("delete", "stop", "resume", "pdf"):
            self.assertEqual(studio.get(f"/api/runs/{run}/{path}").status, 404, path)
        self.assertEqual(studio.get("/api/start").status, 404)
        self.assertTrue((self.runs / run / "summary.json").exists())

    def test_only_folders_that_suffuse_finished_can_be_deleted(self):
        run = self.finished_run()
        (self.runs / "photos").mkdir()
        (self.runs / "photos" / "holiday.jpg").write_text("mine")
        (self.runs / "half").mkdir()
        (self.runs / "half" / "case.resolved.toml").write_text("")
        studio = self.studio()
        self.assertEqual(studio.post("/api/runs/photos/delete").status, 404)
        self.assertEqual(studio.post("/api/runs/half/delete").status, 403)
        self.assertEqual(studio.post(f"/api/runs/{run}/delete").status, 200)
        self.assertFalse((self.runs / run).exists())
        self.assertTrue((self.runs / "photos" / "holiday.jpg").exists())
        self.assertTrue((self.runs / "half").exists())

    def test_words_of_a_form_are_no_options(self):
        studio = self.studio()
        target = self.folder / "written.html"
        fields = {"curve": ("-o" + str(target), CURVE), "sample": f"x --output={target}", "page": "yes", "output": str(target)}
        studio.post("/api/assess", fields)
        self.assertFalse(target.exists())
        for name in ("../case.toml", "/etc/x", "data/../x", ".hidden", "data/sub/x", "-o"):
            self.assertEqual(studio.post("/api/check", {"case": "schema = 1", "file:" + name: CURVE}).status, 400, name)


class Ports(InAFolder):
    def test_a_port_that_is_taken_is_named_and_the_next_one_is_offered(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            studio = self.studio("--port", str(port))
            self.assertEqual(studio.process.wait(60), 2)
            self.assertRegex(studio.end(), rf"port {port} is taken; the next free one is --port \d+")

    def test_two_studios_on_one_folder_both_answer(self):
        run = self.finished_run()
        first, second = self.studio(), self.studio()
        self.assertNotEqual(first.port, second.port)
        for studio in (first, second):
            self.assertEqual([r["name"] for r in studio.get_json("/api/runs")["result"]["runs"]], [run])
            self.assertEqual(studio.get_json("/api/names")["result"], [run])
        self.assertEqual(second.get("/", headers={"Cookie": first.cookie}).status, 401)
        self.assertRegex(second.end(), rf"port \d+ is taken, perhaps by another studio; this one takes {second.port}\n")  # the first may not have had 8610

    def test_many_reloads_at_once_all_have_the_list_as_it_is(self):
        run = self.finished_run()
        studio = self.studio()
        with concurrent.futures.ThreadPoolExecutor(12) as pool:
            for answer in pool.map(lambda _: studio.get_json("/api/runs"), range(12)):
                self.assertEqual([r["name"] for r in answer["result"]["runs"]], [run])
        self.assertEqual(studio.post(f"/api/runs/{run}/delete").status, 200)
        self.assertEqual(studio.get_json("/api/runs")["result"]["runs"], [])

    def test_it_ends_with_ctrl_c(self):
        studio = self.studio()
        studio.end(signal.SIGINT)
        self.assertEqual(studio.process.returncode, 0)


class Soils(InAFolder):
    def test_the_criteria_are_those_of_assess(self):
        (self.folder / "gap.csv").write_text(CURVE)
        by_program = json.loads(self.suffuse("assess", "gap.csv", "-i", "0.3", "--flow", "up", "--json").stdout)["soils"][0]
        studio = self.studio()
        answer = json.loads(studio.post("/api/assess", {"curve": ("gap.csv", CURVE), "gradient": "0.3", "flow": "up"}).text)
        by_studio = answer["result"]["soils"][0]
        self.assertTrue(by_studio.pop("soil").endswith(by_program.pop("soil")))
        self.assertEqual(by_studio, by_program)

    def test_one_soil_of_a_filters_sheet_is_named_as_in_assess_and_new(self):
        sheet = "sample,d [mm],passing [%]\nfine,0.9,0\nfine,1.2,100\ncoarse,1.4,0\ncoarse,1.8,100\n"
        (self.folder / "gap.csv").write_text(CURVE)
        (self.folder / "filters.csv").write_text(sheet)
        filters = ["gap.csv", "--filter", "filters.csv", "--filter-sample", "coarse", "--json"]
        by_program = json.loads(self.suffuse("assess", *filters).stdout)["soils"][0]["filter"]
        studio = self.studio()
        fields = {"curve": ("gap.csv", CURVE), "filter": ("filters.csv", sheet), "filter-sample": "coarse"}
        by_studio = json.loads(studio.post("/api/assess", fields).text)["result"]["soils"][0]["filter"]
        self.assertEqual(by_studio["criteria"], by_program["criteria"])
        base = "d [mm],passing [%]\n0.2,0\n0.25,50\n0.3,100\n"
        made = json.loads(studio.post("/api/new", {**fields, "curve": ("base.csv", base)}).text)["result"]
        self.assertIn("coarse", made["case"])
        self.assertEqual(sorted(made["files"]), ["data/base.csv", "data/coarse.csv"])
        unnamed = studio.post("/api/assess", {**fields, "filter-sample": ""})
        self.assertEqual(unnamed.status, 422)

    def test_a_misread_column_is_corrected_by_its_number(self):
        sheet = "a;b;c\n4;9;100\n2;9;60\n1;9;20\n0.5;9;0\n"
        studio = self.studio()
        corrected = {"curve": ("sheet.csv", sheet), "size": "1:mm", "passing": "3"}
        soil = json.loads(studio.post("/api/reading", corrected).text)["result"]["soils"][0]
        self.assertEqual(soil["passing"], [0, 0.2, 0.6, 1])

    def test_a_file_that_cannot_be_read_is_refused_with_its_place(self):
        answer = self.studio().post("/api/assess", {"curve": ("dam.csv", "d [mm],passing [%]\n1,50\n2,oops\n")})
        self.assertEqual(answer.status, 422)
        self.assertIn("dam.csv", json.loads(answer.text)["error"]["message"])


class Runs(InAFolder):
    def case(self, studio):
        made = json.loads(studio.post("/api/new", {"from": "replay"}).text)["result"]
        return {"case": made["case"], **{"file:" + name: text for name, text in made["files"].items()}}

    def long_case(self, studio):
        fields = {"curve": ("gap.csv", CURVE), "gradient": "0.3", "flow": "up", "particles": "9000"}
        made = json.loads(studio.post("/api/new", fields).text)["result"]
        return {"name": "Dam, north", "case": made["case"], **{"file:" + name: text for name, text in made["files"].items()}}

    def test_a_case_is_checked_priced_and_run_as_an_ordinary_run(self):
        studio = self.studio()
        case = self.case(studio)
        plan = json.loads(studio.post("/api/plan", case).text)["result"]
        self.assertGreater(plan["memory"], 0)
        started = studio.post("/api/start", {**case, "name": "My replay!"})
        self.assertEqual(started.status, 201, started.text)
        self.assertEqual(json.loads(started.text)["run"], "my-replay-0001")
        run = self.runs / "my-replay-0001"
        self.wait("the run ends", lambda: (run / "summary.json").exists() and not studio.get_json("/api/runs/my-replay-0001")["at_work"])
        self.suffuse("verify", "runs/my-replay-0001")
        state = studio.get_json("/api/runs/my-replay-0001")
        self.assertTrue(state["report"] and state["can_delete"])
        self.assertEqual(state["events"][-1]["event"], "run ends")
        self.assertEqual(studio.get("/runs/my-replay-0001/report.html").headers["Content-Type"], "text/html; charset=utf-8")

    def test_the_number_of_a_deleted_run_is_not_used_again_for_its_case_is_kept(self):
        studio = self.studio()
        case, names = self.case(studio), []
        for title in ("one", "two"):
            changed = {**case, "case": re.sub(r"title *=.*", f'title = "{title}"', case["case"]), "name": "again"}
            names.append(json.loads(studio.post("/api/start", changed).text)["run"])
            run = self.runs / names[-1]
            self.wait("the run ends", lambda: (run / "summary.json").exists() and not studio.get_json(f"/api/runs/{names[-1]}")["at_work"])
            self.assertEqual(studio.post(f"/api/runs/{names[-1]}/delete").status, 200)
        self.assertEqual(names, ["again-0001", "again-0002"])
        self.assertIn('"one"', (self.runs / "cases" / "again-0001" / "case.toml").read_text())

    def test_a_folder_that_is_gone_is_named_with_what_to_do(self):
        studio = self.studio()
        self.runs.rmdir()
        answer = studio.get("/api/names")
        self.assertEqual(answer.status, 500)
        message = json.loads(answer.text)["error"]["message"]
        self.assertEqual(message, f"{self.runs}: No such file or directory; if the folder was moved or removed, end the studio and start it again")

    def test_the_last_words_of_a_run_are_shown_and_none_behind_a_link(self):
        run = self.finished_run()
        studio = self.studio()
        last_words = lambda: studio.get_json(f"/api/runs/{run}")["last_words"]
        self.assertEqual(last_words(), "")  # it was not started here
        log = self.runs / "cases" / run / "log.txt"
        log.parent.mkdir(parents=True)
        log.write_text("x" * 10_000 + "no space left")
        self.assertEqual(last_words(), "x" * (4000 - 13) + "no space left")
        (self.folder / "secret").write_text("secret")
        log.unlink()
        log.symlink_to(self.folder / "secret")
        self.assertEqual(last_words(), "")

    def test_every_example_that_is_offered_can_be_started_from(self):
        studio = self.studio()
        names = studio.get_json("/api/examples")["result"]
        self.assertIn("fontainebleau-2016", names)
        for name in names:
            answer = studio.post("/api/new", {"from": name})
            self.assertEqual(answer.status, 200, name)
            self.assertIn("schema = 1", json.loads(answer.text)["result"]["case"], name)

    def test_the_form_of_a_test_has_the_keys_of_the_program(self):
        keys = [key for key in self.studio().get_json("/api/keys")["result"]["keys"] if key["table"] == "stage.oedometer"]
        by_program = json.loads(self.suffuse("schema", "--json").stdout)["keys"]
        self.assertEqual(keys, [key for key in by_program if key["table"] == "stage.oedometer"])
        self.assertEqual([key["name"] for key in keys if key["required"]], ["stresses"])

    def test_an_error_of_a_case_has_its_line(self):
        studio = self.studio()
        case = self.case(studio)
        lines = case["case"].splitlines()
        at = next(k for k, line in enumerate(lines) if line.startswith("friction"))
        lines[at] = 'frictoin = "37 deg"'
        for path in ("/api/check", "/api/plan", "/api/start"):
            answer = studio.post(path, {**case, "case": "\n".join(lines)})
            self.assertEqual(answer.status, 422, answer.text)
            self.assertIn(at + 1, [p["line"] for p in json.loads(answer.text)["error"]["problems"]])
        self.assertFalse((self.runs / "run-0001").exists())

    def test_a_run_outlives_a_killed_studio_and_another_one_stops_and_resumes_it(self):
        first = self.studio()
        started = first.post("/api/start", self.long_case(first))
        self.assertEqual(started.status, 201, started.text)
        first.end(signal.SIGKILL)
        second = self.studio()
        path = "/api/runs/dam-north-0001"
        state = second.get_json(path)
        self.assertTrue(state["at_work"] and state["can_stop"], state)
        self.assertEqual(second.post(path + "/delete").status, 409)
        self.assertEqual(second.post(path + "/resume").status, 409)
        self.assertEqual(second.post(path + "/stop").status, 202)
        self.wait("the run saves itself", lambda: not second.get_json(path)["at_work"])
        self.assertEqual(second.get_json(path)["events"][-1]["outcome"], "stopped")
        self.assertEqual(second.post(path + "/stop").status, 409)
        self.assertEqual(second.post(path + "/resume").status, 201)
        self.assertTrue(second.get_json(path)["at_work"])
        self.assertIn("still at work: suffuse watch runs/dam-north-0001", second.end())
        third = self.studio("--save-runs")
        self.assertTrue(third.get_json(path)["at_work"])
        self.assertIn("saved; resume with: suffuse resume runs/dam-north-0001", third.end())
        self.assertEqual(json.loads((self.runs / "dam-north-0001/events.jsonl").read_text().splitlines()[-1])["outcome"], "stopped")

    def test_runs_that_do_not_fit_into_memory_together_are_refused(self):
        studio = self.studio()
        case = self.long_case(studio)
        self.assertEqual(studio.post("/api/start", case).status, 201)
        run = self.runs / "dam-north-0001"
        plan = json.loads((run / "plan.json").read_text())
        (run / "plan.json").write_text(json.dumps({**plan, "memory": 1e15}))
        refused = studio.post("/api/start", case)
        self.assertEqual(refused.status, 409)
        self.assertIn("memory", json.loads(refused.text)["error"]["message"])
        self.assertFalse((self.runs / "dam-north-0002").exists())
        studio.post("/api/runs/dam-north-0001/stop")
        self.wait("the run saves itself", lambda: not studio.get_json("/api/runs/dam-north-0001")["at_work"])

    def test_the_pictures_of_grains_are_listed_newest_first_and_none_behind_a_link(self):
        run = self.finished_run()
        studio = self.studio()
        pictures = [picture["file"] for picture in studio.get_json(f"/api/runs/{run}/pictures")["result"]]
        stages = ("seep", "compressed", "settled", "start")
        self.assertEqual(pictures, [f"studies/replay/{stage}/grains.vtp" for stage in stages])
        self.assertTrue(studio.get(f"/runs/{run}/{pictures[0]}").text.startswith(b"<?xml"))
        secret = self.folder / "grains.vtp"
        secret.write_text("secret")
        stage = self.runs / run / "studies/replay/seep"
        (stage / "strain-0001.vtp").symlink_to(secret)
        (stage / "own.vtp").write_text("not a picture of grains")
        self.assertEqual([p["file"] for p in studio.get_json(f"/api/runs/{run}/pictures")["result"]], pictures)
        self.assertEqual(studio.get(f"/runs/{run}/studies/replay/seep/strain-0001.vtp").status, 404)
        self.assertEqual(studio.get(f"/api/runs/{run}/pictures", cookie=False).status, 401)
        self.assertEqual(studio.get("/api/runs/..%2Fsecret/pictures").status, 404)

    def test_nothing_is_compressed_for_a_browser_on_the_same_machine(self):
        run = self.finished_run()
        studio = self.studio()
        files = {"/studio.js": None, f"/runs/{run}/report.html": self.runs / run / "report.html", "/api/names": None}
        for path, file in files.items():
            answer = studio.get(path, headers={"Accept-Encoding": "gzip, deflate, br"})
            self.assertEqual((answer.status, answer.headers["Content-Encoding"]), (200, None), path)
            self.assertEqual(int(answer.headers["Content-Length"]), len(answer.text), path)
            if file:
                self.assertEqual(answer.text, file.read_bytes())
        (self.runs / run / "empty.txt").write_text("")
        self.assertEqual(studio.get(f"/runs/{run}/empty.txt").text, b"")
        head = studio.request("HEAD", "/studio.js")
        self.assertEqual((head.status, head.text), (200, b""))

    def test_two_runs_are_compared(self):
        run = self.finished_run()
        self.suffuse("run", "replay/case.toml", "-q")
        answer = self.studio().get_json(f"/api/compare/{run}/replay-0002")
        self.assertTrue(answer["result"])


if __name__ == "__main__":
    main()
