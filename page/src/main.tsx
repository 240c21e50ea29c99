/** The studio: every room registers its panels and commands, then the window is drawn. */
import { render } from "preact";
import { connect } from "./connection/stream.ts";
import "virtual:tokens.css";
import "./look/base.css";
import "./project/project.css";
import { followServer } from "./shell/Banner.tsx";
import { Shell } from "./shell/Shell.tsx";
import { followJobs } from "./state/jobs.ts";
import { followProject } from "./state/project.ts";
import { register as drawing } from "./drawing/register.ts";
import { register as editor } from "./editor/register.ts";
import { register as handsOn } from "./hands_on/register.ts";
import { register as player } from "./player/register.ts";
import { register as project } from "./project/register.ts";
import { register as results } from "./results/register.ts";
import { register as studies } from "./studies/register.ts";
import { register as statics } from "./statics/register.ts";
import { register as window } from "./shell/window.ts";

for (const register of [window, project, drawing, editor, statics, player, results, studies, handsOn]) register();
followProject();
followJobs();
followServer();
connect();
render(<Shell />, document.getElementById("studio")!);
