# SPDX-License-Identifier: MIT
import dermis

picture = dermis.render("built-in", size=(512, 512), background="studio", environment="studio")
picture.save("head.png")
print(picture.display.shape, picture.display.dtype)  # (512, 512, 4) uint8
print(picture.linear.shape, picture.linear.dtype)  # (512, 512, 4) float32
