"""The materials that programs' virtual goniometers measure: words for `brdf export`, the same for every program."""

COOK = "--form cook_torrance --set kd={kd} --set ks={ks} --set f0={f0}"


def metal(f0, **shape):
    return lobe(0, 1, f0, **shape)


def lobe(kd, ks, f0, **shape):
    return " ".join([COOK.format(kd=kd, ks=ks, f0=f0), *(f"--set {name}={value}" for name, value in shape.items())])


MATERIALS = {
    # diffuse
    "white": "--form lambert --set rho=0.9,0.5,0.2",
    "clay": "--form oren_nayar --set rho=0.6,0.5,0.4 --set sigma=0.4",
    "plaster": "--form oren_nayar_energy --set rho=0.8,0.78,0.7 --set roughness=0.7",
    # metals, from mirrors to cast iron
    "mirror": metal("0.95,0.93,0.88", alpha=0.02),
    "chrome": metal("0.55,0.56,0.57", alpha=0.05),
    "gold": metal("0.95,0.64,0.28", alpha=0.1),
    "copper": metal("0.9,0.6,0.3", alpha=0.2),
    "bronze": metal("0.7,0.5,0.3", alpha=0.3),
    "pewter": metal("0.6", alpha=0.45),
    "cast_iron": metal("1,0.8,0.6", alpha=0.7),
    "heavy_tails": "--form cook_torrance_student --set gamma=3 --set kd=0 --set ks=1 --set f0=0.7,0.6,0.5 --set alpha=0.2",
    "beckmann": "--form cook_torrance_beckmann --set kd=0 --set ks=1 --set f0=0.8,0.7,0.5 --set alpha=0.3",
    # brushed and turned metals
    "brushed": metal("0.9,0.6,0.3", alpha_x=0.3, alpha_y=0.1),
    "brushed_across": metal("0.9,0.6,0.3", alpha_x=0.1, alpha_y=0.3, tangent_phi=30),
    "turned": metal("0.8,0.78,0.75", alpha_x=0.4, alpha_y=0.08, tangent_phi=-40),
    "half_turned": metal("0.7", alpha_x=0.25, alpha_y=0.2, tangent_phi=75),
    "rough_brushed": metal("0.95,0.9,0.8", alpha_x=0.6, alpha_y=0.3, tangent_phi=120),
    "brushed_paint": lobe("0.1", "0.9", "0.5", alpha_x=0.3, alpha_y=0.15, tangent_phi=15),
    # plastics and paints
    "gloss": lobe("0.3,0.2,0.1", 1, 0.04, alpha=0.03),
    "plastic": lobe("0.3,0.2,0.1", 1, 0.04, alpha=0.2),
    "matte_plastic": lobe("0.1,0.3,0.5", 1, 0.05, alpha=0.5),
    "weak_plastic": lobe("0.5,0.4,0.3", 0.5, 0.04, alpha=0.15),
    "black_plastic": lobe("0.01,0.01,0.012", 1, 0.045, alpha=0.1),
    "varnish": "--form cook_torrance_dielectric --set kd=0.35,0.2,0.1 --set ks=1 --set eta=1.5 --set alpha=0.08",
    "rubber": "--form cook_torrance_dielectric --set kd=0.04 --set ks=1 --set eta=1.5 --set alpha=0.5",
    "blinn": "--form blinn_phong --set kd=0.3,0.2,0.1 --set ks=0.2 --set exponent=100",
    "ward": "--form ward --set kd=0.2 --set ks=0.3 --set alpha=0.2",
    "half_metal": "--form gltf_metallic_roughness --set base_color=0.6,0.3,0.1 --set metallic=0.5 --set eta=1.6 --set alpha_x=0.3"
                  " --set alpha_y=0.3 --set specular=0.7",
    # lobes with a colour of their own
    "coloured_lobe": lobe("0.1", "0.6,0.4,0.2", 0.5, alpha=0.3),
    "anodised": lobe("0.02,0.03,0.1", "0.2,0.4,0.9", 0.8, alpha=0.15),
    "satin": lobe("0.05", "0.9", "0.7,0.6,0.5", alpha=0.4),
    "tinted_varnish": lobe("0.2,0.05,0.02", "1,0.8,0.6", 0.06, alpha=0.12),
}

# Materials with a program's own formula, or with properties that other programs lack. No table counts these materials.
OWN = {
    "blender-3.4": {
        "own_glossy": "--form blender_glossy --set kd=0.3,0.2,0.1 --set ks=0.2 --set alpha=0.3",
        "own_bright": "--form blender_glossy --set kd=0.2 --set ks=1.5,0.7,0.3 --set alpha=0.25",
        "own_brushed": "--form blender_glossy --set kd=0.1 --set ks=0.8 --set alpha_x=0.1 --set alpha_y=0.4 --set tangent_phi=30",
        "own_paint": "--form blender_principled --set base_color=0.6,0.3,0.1 --set metallic=0 --set eta=1.45 --set alpha=0.2",
        "own_half_metal": "--form blender_principled --set base_color=0.6,0.3,0.1 --set metallic=0.5 --set eta=1.6 --set alpha=0.1",
    },
    "three": {
        "own_half_metal": "--form three_physical --set base_color=0.6,0.3,0.1 --set metallic=0.5 --set eta=1.6 --set alpha=0.3"
                          " --set specular=0.7",
    },
    "gltf": {},
}
