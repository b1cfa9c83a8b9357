package org.dronemap.ws.command;

import java.net.URI;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;

/** Response to a command: 202 while it is under way, 200 with its outcome. */
public final class CommandResponse {
    private static final int LONGEST_WAIT_SECONDS = 60;

    private CommandResponse() {}

    static ResponseEntity<CommandView> of(CommandView command) {
        return answer(command.outcome() == null ? HttpStatus.ACCEPTED : HttpStatus.OK, command);
    }

    /** Who does not wait is told that it is under way, also where its outcome was quicker than the answer. */
    public static ResponseEntity<CommandView> begun(CommandView command) {
        return answer(HttpStatus.ACCEPTED, command);
    }

    private static ResponseEntity<CommandView> answer(HttpStatus status, CommandView command) {
        return ResponseEntity.status(status)
                .location(URI.create("/api/v1/commands/" + command.id()))
                .body(command);
    }

    /** The outcome, if it comes in that time; else the command under way. */
    public static CompletableFuture<ResponseEntity<CommandView>> within(
            Duration longest, CommandService commands, CommandView command) {
        return longest.isZero()
                ? CompletableFuture.completedFuture(of(command))
                : commands.awaitEnd(command, longest).thenApply(CommandResponse::of);
    }

    public static Duration wait(@Nullable Double seconds) {
        if (seconds == null) {
            return Duration.ZERO;
        }
        if (!(seconds >= 0 && seconds <= LONGEST_WAIT_SECONDS)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "wait",
                    "0 to " + LONGEST_WAIT_SECONDS + " seconds",
                    seconds,
                    ProblemParameter.LEAST.is(0),
                    ProblemParameter.MOST.is(LONGEST_WAIT_SECONDS),
                    ProblemParameter.UNIT.is("seconds"));
        }
        return Duration.ofMillis(Math.round(seconds * 1000));
    }
}
