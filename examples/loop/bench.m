% A line stepped from MATLAB, as bench.c steps it from C. Not run by us: we have no MATLAB.
%
%     arcless fmu library .
%     arcless fmu export SCENARIO --out line.loop
%
% loadlibrary needs a C compiler that MATLAB knows: see "mex -setup".
if ~libisloaded('arcless_loop')
    loadlibrary('libarcless_loop', 'arcless_loop.h', 'alias', 'arcless_loop');
end
text = blanks(500);
[line, ~, text] = calllib('arcless_loop', 'arcless_loop_open', 1, 'line.loop', text, 500);
if isNull(line)
    error('arcless:open', '%s', text);
end
force = calllib('arcless_loop', 'arcless_loop_find', line, 'P1.contact_force');
height = calllib('arcless_loop', 'arcless_loop_find', line, 'P1.wire_height');
h = calllib('arcless_loop', 'arcless_loop_step_length', line);
value = libpointer('doublePtr', 0);
for step = 0:1999
    newtons = 120 + 40 * sin(20 * step * h);
    failed = calllib('arcless_loop', 'arcless_loop_set', line, force, newtons, 1) ...
        || calllib('arcless_loop', 'arcless_loop_step', line) ...
        || calllib('arcless_loop', 'arcless_loop_get', line, height, value, 1);
    if failed
        error('arcless:step', '%s', calllib('arcless_loop', 'arcless_loop_message', line));
    end
    wire(step + 1) = value.Value;
end
calllib('arcless_loop', 'arcless_loop_close', line);
plot((1:2000) * h, wire), xlabel('s'), ylabel('m')
