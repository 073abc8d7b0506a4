"""Words that languages keep for themselves: a program of that name is none.

Key words, and what the files written here call; not confirmed on controllers, which may keep more.
"""

from __future__ import annotations

URSCRIPT = frozenset(
    "and break continue def elif else end False global halt if local not or return run sec struct thread True while "
    "xor kill join pass set_tcp set_payload set_digital_out movej movel movec movep sleep textmsg get_inverse_kin "
    "pose_trans".split()
)
#: RAPID, KRL and PacScript do not tell large letters from small ones.
RAPID = frozenset(
    "alias and backward case connect const default div do else elseif endfor endfunc endif endmodule endproc endrecord "
    "endtest endtrap endwhile error exit false for from func goto if inout local mod module nostepin not noview or "
    "pers proc raise readonly record retry return step sysmodule task test then to trap true trynext undo var "
    "viewonly while with xor bool num string robtarget jointtarget tooldata wobjdata speeddata zonedata moveabsj movej "
    "movel movec setdo waittime".split()
)
KRL = frozenset(
    "anin anout and b_and b_exor b_not b_or bas bool brake case char channel circ circ_rel confirm const continue decl "
    "def default deffct defdat delay do else end enddat endfct endfor endif endloop endspline endswitch endwhile "
    "enum "
    "exit exor ext extfct false for frame global goto halt if import int interrupt is lin lin_rel loop maximum minimum "
    "not off on or pos e6pos axis e6axis ptp ptp_rel pulse real repeat resume return scirc signal slin spline sptp "
    "step "
    "struc switch then to trigger true until wait when while".split()
)
PACSCRIPT = frozenset(
    "and as boolean byref byval call case const delay dim do double draw else elseif end exit false for function "
    "givearm "
    "goto if integer io keep long loop mod move next not object on off or rotate select single string sub takearm then "
    "to true until variant wend while with xor".split()
)
