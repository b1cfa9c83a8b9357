package org.dronemap.ws.journal;

import java.util.List;
import org.dronemap.cognitive.operation.recovery.RecoveryInput;
import org.dronemap.cognitive.operation.recovery.RecoveryState;

/** Reads and writes states and inputs of recoveries as text for the journal of operations. */
public final class RecoveryJournalCodec extends JsonOperationCodec<RecoveryState, RecoveryInput> {
    public RecoveryJournalCodec() {
        super(RecoveryState.class, RecoveryInput.class, List.of());
    }
}
