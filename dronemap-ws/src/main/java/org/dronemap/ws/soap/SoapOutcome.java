package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.CommandView;
import org.dronemap.ws.service.Rejection;
import org.jspecify.annotations.Nullable;

/** How a command ended, or {@code underWay}. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "commandOutcome",
        namespace = Namespace.URI,
        propOrder = {"commandId", "result", "by", "reason", "code", "warning"})
public class SoapOutcome {
    @XmlElement(required = true)
    private String commandId = "";

    @XmlElement(required = true)
    private String result = "";

    private @Nullable String by;
    private @Nullable String reason;
    private @Nullable String code;
    private List<String> warning = new ArrayList<>();

    static SoapOutcome of(CommandView command) {
        CommandView.OutcomeView outcome = command.outcome();
        SoapOutcome soap = of(
                command.id(),
                outcome == null
                        ? new CommandView.OutcomeView(
                                "underWay", null, "It has not ended yet; ask for it by getCommand.", null)
                        : outcome);
        soap.warning.addAll(command.warnings());
        return soap;
    }

    /** Of a command that was not carried out. */
    static SoapOutcome refused(String commandId, Rejection why) {
        return of(
                commandId,
                new CommandView.OutcomeView(
                        "refused", "gate", why.sentence(), why.code().word()));
    }

    private static SoapOutcome of(String commandId, CommandView.OutcomeView outcome) {
        SoapOutcome soap = new SoapOutcome();
        soap.commandId = commandId;
        soap.result = outcome.result();
        soap.by = outcome.by();
        soap.reason = outcome.reason();
        soap.code = outcome.code();
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

    public @Nullable String getCode() {
        return code;
    }

    public List<String> getWarning() {
        return List.copyOf(warning);
    }

    public @Nullable String getReason() {
        return reason;
    }
}
