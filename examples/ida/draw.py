"""Draws impact force over scale from the sweep's table and says where half of the runs touch the rim."""
import matplotlib.pyplot as plt
import numpy as np
import rimpact

runs = rimpact.load_fleet("fleet").runs
figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
axes.plot(runs["excitation.scale"], runs.peak_impact_force_N.fillna(0) / 1e3, ".", color="0.6", label="one run")
levels = runs.groupby("excitation.scale")
axes.plot(levels.peak_impact_force_N.median().fillna(0) / 1e3, "k-", label="median")
axes.set(xlabel="scale of the pulse", ylabel="peak impact force [kN]")
axes.legend()
figure.savefig("picture.png", dpi=90)
share = levels.n_impacts.apply(lambda n: (n > 0).mean())
print(f"half of the runs touch the rim at scale {np.interp(0.5, share, share.index):.3f}")
