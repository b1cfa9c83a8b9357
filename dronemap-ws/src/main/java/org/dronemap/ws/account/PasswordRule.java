package org.dronemap.ws.account;

import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Checks that a new password of a user is neither too short nor too long. */
public final class PasswordRule {
    public static final int SHORTEST = 10;
    public static final int LONGEST = 200;

    private PasswordRule() {}

    public static String acceptable(String field, @Nullable String password) {
        String allowed = SHORTEST + " to " + LONGEST + " characters";
        if (password == null) {
            throw InvalidInput.missing(field, allowed);
        }
        if (password.length() < SHORTEST || password.length() > LONGEST) {
            throw new InvalidInput(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    field,
                    allowed,
                    "A password must have " + allowed + "; this one has " + password.length() + ".",
                    ProblemParameter.LEAST.is(SHORTEST),
                    ProblemParameter.MOST.is(LONGEST));
        }
        return password;
    }
}
