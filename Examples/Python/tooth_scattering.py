# SPDX-License-Identifier: BSD-3-Clause
"""A scanned tooth without and with scattering inside (figure 2.53).

python3 tooth_scattering.py IMAGE.png
"""

import numpy as np
from interlume import vtkShadowedSliceSettings as settings
from props import (
    make_colors, make_opacities, make_parallel_light, make_sliced_volume, read, smooth)
from stage import Stage

tooth = smooth(read("tooth.vti"), (1.2, 1.2, 2.5))  # hides the rings of the scan
stage = Stage()
without, within = map(stage.add_panel, ("light that is reflected", "light that is scattered inside"))
for panel, key, fill in ((without, 1.8, 1.0), (within, 0.44, 0.12)):
    volume = make_sliced_volume(tooth)
    medium, mapper = volume.GetProperty(), volume.GetMapper()
    medium.SetScalarOpacity(make_opacities((115.0, 0.0), (150.0, 0.35), (255.0, 0.45)))
    medium.SetColor(make_colors((90.0, 0.93, 0.86, 0.72), (190.0, 0.97, 0.95, 0.90)))
    medium.SetAmbient(0.2)
    medium.SetDiffuse(0.8)
    medium.SetSpecular(0.0)
    if panel is within:
        mapper.SetScatteringMode(settings.FULL_SCATTERING)
        mapper.SetPhaseFunctionToHenyeyGreenstein()
        mapper.SetAnisotropy(0.8)
        mapper.SetScatteringGridSize(64)
        mapper.SetScatteringAlbedo(
            make_colors((90.0, 0.998, 0.990, 0.965), (190.0, 0.999, 0.996, 0.985)))
    panel.add(volume)
    panel.set_lights(make_parallel_light((1.0, 0.55, 0.5), key, (1.0, 0.95, 0.85)),
                     make_parallel_light((-0.7, -1.0, 0.6), fill))
    panel.set_background((0.20, 0.23, 0.28), (0.06, 0.07, 0.09))
    lower, upper = np.reshape(tooth.GetBounds(), (3, 2)).T[:, :, None]
    fractions = np.array([(0.16, 0.84), (0.45, 0.55), (0.12, 1.0)])
    panel.frame(*(lower + fractions * (upper - lower)).ravel())
without.look_from((0.25, -1.0, 0.25))
within.look_as(without)
stage.save()
