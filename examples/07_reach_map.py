"""A map: what an arm reaches in half a cubic metre, in how many orientations, and how far from its limits."""

import pieper

arm = pieper.load("denso-vp6242")
m = arm.reach_map(((-0.45, 0.45), (-0.45, 0.45), (-0.1, 0.7)), 0.05, orientations=(64, 8), measure=True)
print(m.explain())
best = m.voxels().points[m.voxels().fraction.argmax()]
print("best served at", (best * 1e3).round(), "mm")
print("farthest from all limits:", f"{m.margin.max():.0%} of half a joint's range")

longer = arm.with_tool(pieper.pose(0, 0, 0.1))
gained = longer.reach_map(((-0.45, 0.45), (-0.45, 0.45), (-0.1, 0.7)), 0.05, orientations=(64, 8)).minus(m)
print(f"a tool 100 mm long gains in {(gained > 0).sum()} voxels and loses in {(gained < 0).sum()}")

m.save("reach.vtk")
negative, positive = m.aspects.reshape(-1, 2).sum(0)
print(f"{negative:,} solutions on one side of the singular postures, {positive:,} on the other")
pieper.plot.save_figure(pieper.plot.layers_figure(m), "slices.png")
pieper.plot.save_figure(pieper.plot.map_figure(m), "reach.png")
pieper.plot.save_figure(pieper.plot.map_figure(m, what="least_singular"), "singular.png")
pieper.plot.save_figure(pieper.plot.map_figure(m, what="margin"), "margin.png")
