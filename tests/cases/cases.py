# SPDX-License-Identifier: MIT
"""Files as people's programs write them, made by the scripts of the shared cases: each is drawn as its
reference is, or said to be refused, or warned of. cases.py PROGRAM SCRIPTS; exit status 77: skipped."""
import glob
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

program, scripts = sys.argv[1:3]
if not glob.glob(os.path.join(scripts, "[0-9]*.py")):
    print("skipped: the scripts of the cases are not at hand:", scripts)
    sys.exit(77)
try:
    import numpy
    from PIL import Image
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

base = """06-armature.glb 11-png-16.glb 11-png-8.glb 11-png-gama.glb 12b-null-channels.glb 12b-null.glb
12b-take001.glb 13-spot-zero.glb 22-deep60.glb 22-deep80.glb 22-deep300.glb 22-long-quaternion.glb
22-matrix-and-trs.glb 22-matrix-row.glb 22-root-twice.glb 22-scale-zero.glb 22-zero-quaternion-helper.glb
23-float-joints.glb 23-joint-out-of-range-weight0.glb 23-joint-out-of-range.glb 23-joints-no-skin.glb
23-joints-outside-scene.glb 23-negative-weight.glb 23-no-ibm.glb 23-unnormalised.glb 23-zero-weights.glb
24-UPPER.GLB 24-bom.glb 24-bom.gltf 24-datauri-charset.gltf 24-datauri-gltf-buffer.gltf 24-datauri.gltf
24-extra-chunk.glb 24-no-extension 24-nul-padding.glb 24-total-short.glb 24-total-zero.glb 24-trailing.glb
24-unaligned.glb 33-colour-stride3.glb 33-extras-of-any-type.glb 33-hidden-node.glb 33-mime-jpg.glb
33-mime-none.glb 33-mime-wrong.glb 33-minmax-none.glb 33-minmax-short.glb 33-minmax-wrong.glb
33-misaligned.glb 33-null-members.glb 33-weights-ref.glb 33-zero-weights.glb"""

# Reference, PSNR in dB that the others have at least, and these.
groups = [
    ("00-base.glb", 80, base),
    ("01-texture-transform-ref.glb", 45, "01-texture-transform.glb"),
    ("03-negscale-ref.glb", 80, "03-negscale.glb"),
    ("03-negscale-made-ref.glb", 80, "03-negscale-made.glb"),
    ("05-morph-ref.glb", 80, "05-morph.glb 05-morph-node.glb"),
    ("05-morph-flat-ref.glb", 80, "05-morph-flat.glb"),
    ("05-morph-no-normals-ref.glb", 80, "05-morph-no-normals.glb"),
    ("07-eight-ref.glb", 80, "07-eight.glb"),
    ("11-grey-8-rgb.glb", 80, "11-grey-8.glb 11-grey-16.glb 11-grey-alpha.glb"),
    ("11-jpg-base.glb", 80, "11-jpg-prog.glb 11-jpg-exif.glb"),
    ("11-palette-rgb.glb", 80, "11-palette.glb"),
    ("13-spot-ref.glb", 60, "13-spot-equal.glb 13-spot-inner-more.glb 13-point-zero-range.glb"),
    ("17-bleed.glb", 60, "17-bleed-onenode.glb"),
    ("18-topo-ref.glb", 70, "18-topo-duplicates.glb"),
    ("18-topo-ref.glb", 75, "18-topo-fan.glb 18-topo-interleaved.glb "
     "18-topo-long-normals.glb 18-topo-matrix.glb 18-topo-strip.glb 18-topo-trailing.glb 18-topo-u8.glb "
     "18-topo-unindexed.glb"),
    ("20-eyes-none.glb", 45, "20-eyes-transmission.glb 20-eyes-volume.glb"),
    ("21-ref.glb", 80, "21-specgloss.glb 21-volscat.glb 21-coat.glb"),
    ("22-camera.glb", 80, "22-camera-scaled.glb 22-camera-zfar-before-head.glb"),
    ("26-cut-ref.glb", 55, "26-cut-turned.glb 26-cut-scaled.glb"),
    ("30-rpm.glb", 80, "30-metahuman.glb"),
    ("34-cc-two-nodes.glb", 60, "34-cc-one-node.glb"),
    ("35-disp-normal.glb", 54.5, "35-disp16.glb"),
    ("00-base.glb --environment 33-sun-finite.exr", 40, "00-base.glb --environment 33-sun-inf.exr"),
]
# What is drawn with a warning, and what is refused, with a part of what is said.
warned = {
    "08-samename.glb": "share the name", "11-webp.glb": "has no PNG or JPEG",
    "13-blender-1000W.glb": "is over white", "13-sun-100klux.glb": "is over white",
    "13-negative-colour.glb": "out of range", "22-camera-behind.glb": "no skin is in the picture",
    "23-one-primitive-without-joints.glb": "has no joints", "30-skinny.glb": "no material is skin",
    "30-german.glb": "no material is skin", "33-missing/missing-lash.gltf": "no such file",
    "06-centimetres.glb": "unit_scale",
}
refused = {
    "11-jpg-cmyk.glb": "CMYK", "11-webp-required.glb": "EXT_texture_webp", "24-nan.gltf": "not valid JSON",
    "24-utf16.gltf": "is not glTF", "33-missing/missing-picture.gltf": "no such file",
}
masks = ["32-mask.glb", "32-mask-dense.glb"]

with tempfile.TemporaryDirectory() as folder:
    for script in sorted(glob.glob(os.path.join(scripts, "[0-9]*.py"))):
        subprocess.run([sys.executable, script], env={**os.environ, "OUT": folder}, check=True,
                       stdout=subprocess.DEVNULL)

    def render(words, *more):
        """The picture, or None, and what the program said."""
        name, *options = words.split()
        options = [os.path.join(folder, o) if o.endswith(".exr") else o for o in options]
        letters = [c if c.isalnum() else "-" for c in words + "".join(more)]
        output = os.path.join(folder, "".join(letters) + ".png")
        small = "--size 120x120 --map-size 256 --shadow-size 256 --bloom 0 --verbose".split()
        ran = subprocess.run([program, "render", os.path.join(folder, name), *small, *options, *more, "-o",
                              output], capture_output=True, text=True)
        if ran.returncode != 0:
            return None, ran.stderr
        return numpy.asarray(Image.open(output).convert("RGB"), dtype=float), ran.stderr

    def check_like(reference, least_db, words):
        wanted, said = references[reference]
        picture, says = render(words)
        if wanted is None or picture is None:
            return f"{words}: not drawn: {said}{says}"
        error = ((wanted - picture) ** 2).mean()
        psnr = 10 * numpy.log10(255**2 / error) if error > 0 else 99
        return f"{words}: {psnr:.1f} dB from {reference}, {least_db} asked" if psnr < least_db else ""

    def check_said(words, text, drawn):
        picture, says = render(words)
        if (picture is not None) == drawn and text in says:
            return ""
        return f"{words}: {'drawn' if picture is not None else 'refused'}, and says {says!r}, not '{text}'"

    def check_dark(words):
        picture, says = render(words, "--light", "180,0", "--ambient", "0")
        return f"{words}: lit from inside it shines" if picture is None or picture.max() > 30 else ""

    with ThreadPoolExecutor(max_workers=2) as pool:
        names_of_references = [reference for reference, _, _ in groups]
        references = dict(zip(names_of_references, pool.map(render, names_of_references)))
        checks = [pool.submit(check_like, reference, db, words) for reference, db, names in groups
                  for words in ([names] if "--" in names else names.split())]
        checks += [pool.submit(check_said, words, text, True) for words, text in warned.items()]
        checks += [pool.submit(check_said, words, text, False) for words, text in refused.items()]
        checks += [pool.submit(check_dark, words) for words in masks]
        faults = [check.result() for check in checks]

faults = [fault for fault in faults if fault]
print(f"{len(checks)} cases, {len(faults)} wrong")
print("\n".join(faults))
sys.exit(1 if faults else 0)
