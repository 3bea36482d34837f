"""Parts of the body by the names of other programs."""

import pytest

from dynsplines.scene.roles import roles

PARTS = ("clavicle", "upper_arm", "forearm", "hand", "thigh", "shin", "foot", "toe")
ABOVE = ("chest", "clavicle", "upper_arm", "forearm", "pelvis", "thigh", "shin", "foot")
LONG = {"L": "left", "R": "right"}
JAPANESE = ("肩", "腕", "ひじ", "手首", "足", "ひざ", "足首", "つま先")
MIXAMO = ("Shoulder", "Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot", "ToeBase")
# pelvis, chest, at times neck, and head; how a part of a side is written; the parts from shoulder to toes
MAKERS = {
    "VRoid": ("J_Bip_C_Hips J_Bip_C_UpperChest J_Bip_C_Head", "J_Bip_{S}_{part}",
              ("Shoulder", "UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "ToeBase")),
    "VRM": ("hips upperChest head", "{side}{part}",
            ("Shoulder", "UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "Toes")),
    "MMD": ("センター 上半身2 頭", "{kanji}{part}", JAPANESE),
    "MMD in Blender": ("センター 上半身2 頭", "{part}.{S}", JAPANESE),
    "MMD in English": ("center upper_body2 head", "{part}_{S}",
                       ("shoulder", "arm", "elbow", "wrist", "leg", "knee", "ankle", "toe")),
    "MMD romanised": ("Sentaa Jouhanshin Atama", "{romaji}{part}",
                      ("Shoulder", "Ude", "Hiji", "Tekubi", "Ashi", "Hiza", "Ashikubi", "Tsumasaki")),
    "Mixamo again": ("mixamorig1_Hips mixamorig1_Spine2 mixamorig1_Head", "mixamorig1_{Side}{part}", MIXAMO),
    "Mixamo in three.js": ("mixamorigHips mixamorigSpine2 mixamorigHead", "mixamorig{Side}{part}", MIXAMO),
    "Rigify": ("DEF-spine DEF-spine.003 DEF-head", "DEF-{part}.{S}",
               ("shoulder", "upper_arm", "forearm", "hand", "thigh", "shin", "foot", "toe")),
    "Daz": ("hip chestUpper head", "{s}{part}",
            ("Collar", "ShldrBend", "ForearmBend", "Hand", "ThighBend", "Shin", "Foot", "Toe")),
    "Character Creator": ("CC_Base_Hip CC_Base_Spine02 CC_Base_Head", "CC_Base_{S}_{part}",
                          ("Clavicle", "Upperarm", "Forearm", "Hand", "Thigh", "Calf", "Foot", "ToeBase")),
    "Motive": ("Skeleton_001_Hip Skeleton_001_Chest Skeleton_001_Head", "Skeleton_001_{S}{part}",
               ("Shoulder", "UArm", "FArm", "Hand", "Thigh", "Shin", "Foot", "Toe")),
    "a robot's character": ("Robot_Hips Robot_Spine2 Robot_Head", "Robot_{Side}{part}", MIXAMO),
    "Source": ("ValveBiped.Bip01_Pelvis ValveBiped.Bip01_Spine4 ValveBiped.Bip01_Head1", "ValveBiped.Bip01_{S}_{part}",
               ("Clavicle", "UpperArm", "Forearm", "Hand", "Thigh", "Calf", "Foot", "Toe0")),
    "Second Life": ("mPelvis mChest mNeck mHead", "m{part}{Side}",
                    ("Collar", "Shoulder", "Elbow", "Wrist", "Hip", "Knee", "Ankle", "Toe")),
    "SMPL": ("Pelvis Chest Neck Head", "{S}_{part}",
             ("Thorax", "Shoulder", "Elbow", "Wrist", "Hip", "Knee", "Ankle", "Foot")),
    "Kinect": ("PELVIS SPINE_CHEST NECK HEAD", "{part}_{SIDE}",
               ("CLAVICLE", "SHOULDER", "ELBOW", "WRIST", "HIP", "KNEE", "ANKLE", "FOOT")),
    "Rigify's spine": ("spine spine.003 spine.004 spine.006", "{part}.{S}",
                       ("shoulder", "upper_arm", "forearm", "hand", "thigh", "shin", "foot", "toe")),
    "Daz of generation 8": ("hip chestUpper neckLower head", "{s}{part}",
                            ("Collar", "ShldrBend", "ForearmBend", "Hand", "ThighBend", "Shin", "Foot", "Toe")),
    "ASF": ("lowerback thorax lowerneck head", "{s}{part}",
            ("clavicle", "humerus", "radius", "wrist", "femur", "tibia", "foot", "toes")),
    "iClone": ("CC_Base_Hip CC_Base_Spine02 CC_Base_NeckTwist01 CC_Base_Head", "CC_Base_{S}_{part}",
               ("Clavicle", "Upperarm", "Forearm", "Hand", "Thigh", "Calf", "Foot", "ToeBase")),
    "Unreal": ("pelvis spine_02 head", "{part}_{s}",
               ("clavicle", "upperarm", "lowerarm", "hand", "thigh", "calf", "foot", "ball")),
    "Poser": ("hip chest neck head", "{s}{part}",
              ("Collar", "Shldr", "ForeArm", "Hand", "Thigh", "Shin", "Foot", "Toe")),
    "ours, short": ("pelvis chest head", "{part}_{s}",
                    ("clavicle", "uarm", "farm", "hand", "thigh", "shin", "foot", "toe")),
    "Maya": ("root_jnt chest_jnt head_jnt", "{part}_{S}_jnt",
             ("clavicle", "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "ball")),
}  # fmt: skip


@pytest.mark.parametrize("maker", MAKERS)
def test_parts_are_known_by_names(maker):
    trunk, pattern, parts = MAKERS[maker]
    middle = trunk.split()
    trunk_roles = ("pelvis", "chest", "head") if len(middle) == 3 else ("pelvis", "chest", "neck", "head")
    expected = dict(zip(trunk_roles, middle, strict=True))
    names, parents = middle.copy(), list(range(-1, len(middle) - 1))
    for letter, side in LONG.items():
        kanji, romaji = {"L": ("左", "Hidari"), "R": ("右", "Migi")}[letter]
        for role, above, part in zip(PARTS, ABOVE, parts, strict=True):
            name = pattern.format(
                S=letter,
                s=letter.lower(),
                side=side,
                Side=side.title(),
                SIDE=side.upper(),
                kanji=kanji,
                romaji=romaji,
                part=part,
            )
            parent = above if above in expected else f"{side}_{above}"
            parents.append(names.index(expected[parent]))
            names.append(name)
            expected[f"{side}_{role}"] = name
    found = roles(names, parents)
    assert {role: names[joint] for role, joint in found.items()} == expected


def test_helpers_beside_a_limb_are_no_parts_of_it():
    """MMD has bones for IK, twist and deformation, VRoid for hair and skirts."""
    limb = {
        "下半身": -1,
        "左足ＩＫ": 0,
        "左足D": 0,
        "左ひざD": 2,
        "左足": 0,
        "左ひざ": 4,
        "左足首": 5,
        "右足": 0,
        "右ひざ": 7,
    }
    names = [*limb, "J_Sec_L_UpperLeg", "J_Sec_Hair1_01", "J_Adj_L_UpperLeg"]
    found = roles(names, [*limb.values(), 0, 0, 0])
    assert {role: names[joint] for role, joint in found.items()} == {
        "pelvis": "下半身", "left_thigh": "左足", "left_shin": "左ひざ", "left_foot": "左足首",
        "right_thigh": "右足", "right_shin": "右ひざ",
    }  # fmt: skip
