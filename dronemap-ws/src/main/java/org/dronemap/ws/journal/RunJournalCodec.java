package org.dronemap.ws.journal;

import java.util.List;
import org.dronemap.cognitive.operation.run.ReplanComputation;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunInput;

/** Reads and writes states and inputs of mission runs as text for the journal of operations. */
public final class RunJournalCodec extends JsonOperationCodec<RunState, RunInput> {
    public RunJournalCodec() {
        super(RunState.class, RunInput.class, List.of(ReplanComputation.class));
    }
}
