package org.dronemap.ws.soap;

import jakarta.xml.bind.ValidationEvent;
import jakarta.xml.bind.ValidationEventHandler;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.PhaseInterceptorChain;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.ValueProblem;

/** Notes which value of a message cannot be read, in the words that the other faces have for it. */
final class UnreadableValues implements ValidationEventHandler {
    @Override
    public boolean handleEvent(ValidationEvent event) {
        Message message = PhaseInterceptorChain.getCurrentMessage();
        Whereabouts whereabouts = message == null ? null : message.getExchange().get(Whereabouts.class);
        if (whereabouts != null && whereabouts.isStartElement()) {
            // An element that nobody knows: StrictElements tells of each.
            return true;
        }
        if (whereabouts != null && !whereabouts.path().isEmpty()) {
            String field = whereabouts.path();
            String allowed =
                    event.getLinkedException() instanceof NumberFormatException ? "a number" : "of another form";
            message.getExchange()
                    .put(
                            InvalidInput.class,
                            new InvalidInput(
                                    ValueProblem.VALUE_MALFORMED,
                                    field,
                                    allowed,
                                    "\"" + field + "\" must be " + allowed + "."));
        }
        return false;
    }
}
