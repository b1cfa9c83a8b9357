package org.dronemap.ws.journal;

import java.util.List;
import org.dronemap.cognitive.operation.run.ReplanComputation;
import org.dronemap.cognitive.operation.run.RunInput;
import org.dronemap.cognitive.operation.run.RunState;

/** Mission runs as text. */
public final class RunCodec extends JsonOperationCodec<RunState, RunInput> {
    public RunCodec() {
        super(RunState.class, RunInput.class, List.of(ReplanComputation.class));
    }
}
