% octave peer_octave.m PROBLEM.json TOLERANCE...: Octave's ode15s on the plain Park-Wen form (problem.cc in Octave).
% Prints a JSON line for each tolerance: seconds and the displacements at the output instants.
1;

function a = ground(p, t)
  if isfield(p, "pulse")
    w = pi * (t - p.pulse.centre) / p.pulse.period;
    a = [p.pulse.amplitude * (1 - 2 * w * w) * exp(-w * w); 0];
  else
    k = min(floor(t / p.record_dt), numel(p.record_x) - 2);
    s = t / p.record_dt - k;
    a = [p.record_x(k + 1) + s * (p.record_x(k + 2) - p.record_x(k + 1));
         p.record_y(k + 1) + s * (p.record_y(k + 2) - p.record_y(k + 1))];
  end
end

function dy = rhs(p, t, y)
  x = y(1:2); v = y(3:4); eta = y(5:6);
  r = norm(x);
  s = sqrt(1 - r * r / p.a ^ 2);
  slope = 1 / (p.R0 * s);
  bend = slope / (p.a * s) ^ 2;
  g = slope * x;
  S = sqrt(1 + g' * g);
  F = -p.mass * ground(p, t);
  xv = x' * v;
  if r > p.capacity
    F -= (p.k_i * (r - p.capacity) + p.c_i * xv / r) / r * x;
  end
  N = (p.mass * (slope * (v' * v) + bend * xv ^ 2) + g' * F + p.weight) / S;
  e2 = eta' * eta;
  rub = 0;
  if e2 > 0
    rub = p.mu * sqrt(e2 / (e2 + (g' * eta) ^ 2));
  end
  dy = [v; (F - N * g / S - N * rub * eta) / p.mass; (v - max(0, eta' * v) * eta) / p.slip];
end

arguments = argv();
p = jsondecode(fileread(arguments{1}));
n = round(p.duration / p.output_step);
instants = min(p.output_step * (0:n), p.duration);
for i = 2:numel(arguments)
  tolerance = str2double(arguments{i});
  options = odeset("RelTol", tolerance, "AbsTol", tolerance, "MaxStep", 0.01);
  begin = cputime();
  [~, y] = ode15s(@(t, y) rhs(p, t, y), instants, zeros(6, 1), options);
  seconds = cputime() - begin;
  printf("%s\n", jsonencode(struct("tolerance", tolerance, "seconds", seconds, "x", y(:, 1)', "y", y(:, 2)')));
end
