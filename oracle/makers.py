"""For each dialect an arm of its maker, and a posture where lines and circles are at home, degrees (m of a slide)."""

#: dialect -> an arm of its maker, a posture where lines and circles are at home
AT_HOME = {
    "rapid": ("abb-irb2400", [5, 10, 5, 10, 30, 15]),
    "urscript": ("universal-robots-ur10e", [10, -70, 90, -60, -80, 20]),
    "krl": ("kuka-kr6-r900-sixx", [-10, -80, 95, 10, 40, -20]),
    "fanuc-ls": ("fanuc-lr-mate-200id", [10, 20, -10, 15, -60, 200]),
    "inform": ("motoman-gp7", [10, 10, -10, 15, -60, 20]),
    "pacscript": ("denso-vs060", [10, 10, 80, 15, 40, 20]),
    "ros": ("kinova-gen3-7dof", [10, 20, 10, 60, 15, 40, 20]),
    "csv": ("stanford-arm", [10, 50, 0.6, 20, 40, 15]),
}
