from pieper.motion.route.freedom import Verdict
def refusal(task):
    return Verdict.UNCERTAIN, None, "not yet"
