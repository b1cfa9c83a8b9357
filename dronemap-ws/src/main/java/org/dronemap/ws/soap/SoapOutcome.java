package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.CommandView;
import org.jspecify.annotations.Nullable;

/** How a command ended, or {@code underWay}. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "commandOutcome",
        namespace = Namespace.URI,
        propOrder = {"commandId", "result", "by", "reason", "warning"})
public class SoapOutcome {
    @XmlElement(required = true)
    private String commandId = "";

    @XmlElement(required = true)
    private String result = "";

    private @Nullable String by;
    private @Nullable String reason;
    private List<String> warning = new ArrayList<>();

    static SoapOutcome of(CommandView command) {
        CommandView.OutcomeView outcome = command.outcome();
        SoapOutcome soap = outcome == null
                ? of(command.id(), "underWay", null, "It has not ended yet; ask for it by getCommand.")
                : of(command.id(), outcome.result(), outcome.by(), outcome.reason());
        soap.warning.addAll(command.warnings());
        return soap;
    }

    static SoapOutcome of(String commandId, String result, @Nullable String by, @Nullable String reason) {
        SoapOutcome soap = new SoapOutcome();
        soap.commandId = commandId;
        soap.result = result;
        soap.by = by;
        soap.reason = reason;
        return soap;
    }

    public String getCommandId() {
        return commandId;
    }

    public String getResult() {
        return result;
    }

    public @Nullable String getBy() {
        return by;
    }

    public List<String> getWarning() {
        return List.copyOf(warning);
    }

    public @Nullable String getReason() {
        return reason;
    }
}
