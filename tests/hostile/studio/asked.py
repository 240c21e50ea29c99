"""Routes of the studio, and paths that lead out of its folder."""

PATHS = [
    "/", "/index.html", "/assets/", "/assets/x.js", "/api", "/api/project", "/api/file",
    "/api/jobs", "/api/jobs/x/cancel", "/api/run", "/api/run/report", "/api/run/line",
    "/api/series", "/api/figures", "/api/figure", "/api/space_time", "/api/explain",
    "/api/assessed", "/api/schema", "/api/stream", "/api/hands_on", "/api/nothing",
]  # fmt: skip
POSTED = ["file", "patch", "check", "form", "new", "variant", "statics", "compare", "jobs/1/cancel"]
LEADING_OUT = [
    "../outside/canary.yaml", "{outside}/canary.yaml", "link.yaml", "away/canary.yaml",
    "/proc/self/environ", "/etc/passwd", "runs/../../outside/canary.yaml", "..", "", ".", "\0",
    "shipped:line/../../../../outside/canary", "%2e%2e%2foutside/canary.yaml", "a" * 5000,
    "away", "run-away", "run-away/result.nc", "\ud7ff.yaml", "my.yaml/..", "my.yaml\n",
]  # fmt: skip
