package org.dronemap.ws.journal;

import java.util.List;
import org.dronemap.cognitive.operation.dispatch.DispatchInput;
import org.dronemap.cognitive.operation.dispatch.DispatchState;

/** Reads and writes states and inputs of dispatches as text for the journal of operations. */
public final class DispatchJournalCodec extends JsonOperationCodec<DispatchState, DispatchInput> {
    public DispatchJournalCodec() {
        super(DispatchState.class, DispatchInput.class, List.of());
    }
}
