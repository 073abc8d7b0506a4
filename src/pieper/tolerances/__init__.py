"""Every tolerance, named for why it exists: a page a subject. Lengths are relative to the arm's characteristic length.

The pages in `kernels` are for Python and C++ both: the build writes a header from them, NAME becoming kName. No name
stands twice, and no file elsewhere writes a threshold as a bare number: a test reads all literals.
"""

from .algebra import *  # noqa: F403
from .arithmetic import *  # noqa: F403
from .calibration import *  # noqa: F403
from .collision import *  # noqa: F403
from .command_line import *  # noqa: F403
from .description import *  # noqa: F403
from .drawing import *  # noqa: F403
from .judge import *  # noqa: F403
from .kernels.closed_forms import *  # noqa: F403
from .kernels.collision import *  # noqa: F403
from .kernels.curves import *  # noqa: F403
from .kernels.descent import *  # noqa: F403
from .kernels.elimination import *  # noqa: F403
from .kernels.equations import *  # noqa: F403
from .kernels.everywhere import *  # noqa: F403
from .kernels.fronts import *  # noqa: F403
from .kernels.hidden_angle import *  # noqa: F403
from .kernels.lanes import *  # noqa: F403
from .kernels.parallel_wrist import *  # noqa: F403
from .kernels.singular import *  # noqa: F403
from .kernels.time_laws import *  # noqa: F403
from .kinematics import *  # noqa: F403
from .motion import *  # noqa: F403
from .routes import *  # noqa: F403
from .solver import *  # noqa: F403
from .verify import *  # noqa: F403
