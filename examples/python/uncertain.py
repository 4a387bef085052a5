"""How friction and the motion's scale spread the impact force: 400 runs in threads, OpenTURNS for sample and statistics."""
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import rimpact

try:
    import openturns as ot
except ImportError:
    raise SystemExit("openturns is not installed (python3-openturns)") from None

scene = rimpact.Scene("ricker-0.78g-1.0s")
inputs = ot.ComposedDistribution([ot.TruncatedDistribution(ot.Normal(0.07, 0.01), 0.04, 0.10), ot.Uniform(1.02, 1.15)])
ot.RandomGenerator.SetSeed(7)
sample = inputs.getSample(400)


def force(point: Sequence[float]) -> list[float]:
    mu, scale = point
    summary = rimpact.summarise(scene.with_settings({"reduced.mu_fast": mu, "reduced.mu_slow": mu, "excitation.scale": scale}))
    return [(summary["peak_impact_force_N"] or 0) / 1e3]


with ThreadPoolExecutor() as pool:
    output = ot.Sample(list(pool.map(force, sample)))
print(f"mean {output.computeMean()[0]:.0f} kN, 95 % {output.computeQuantile(0.95)[0]:.0f} kN")
print(f"rank correlation: friction {ot.CorrelationAnalysis(sample, output).computeSpearmanCorrelation()[0]:+.2f}, "
      f"scale {ot.CorrelationAnalysis(sample, output).computeSpearmanCorrelation()[1]:+.2f}")
