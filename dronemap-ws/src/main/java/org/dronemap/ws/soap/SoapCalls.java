package org.dronemap.ws.soap;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import javax.xml.transform.Source;
import org.apache.cxf.binding.soap.SoapFault;
import org.apache.cxf.message.Message;
import org.dronemap.core.audit.Activity;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.problem.Problem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.reading.JsonReader;
import org.dronemap.ws.security.CalledBy;
import org.dronemap.ws.soap.description.SoapOperation;
import org.dronemap.ws.soap.description.SoapServices;
import org.dronemap.ws.soap.xml.Namespace;
import org.dronemap.ws.soap.xml.XmlType;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Element;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;

/** Carries out calls by requests to REST, and makes messages of what it answers. Any thread. */
public final class SoapCalls {
    private static final int FIRST_REFUSAL = 400;
    private static final String COMMAND_ID = "commandId";
    private static final XmlType COMMAND = new XmlType.Named("CommandView");

    private final SoapContract contract;
    private final SoapCaller caller;
    private final RestCalls rest;
    private final JsonReader json;

    public SoapCalls(SoapContract contract, SoapCaller caller, RestCalls rest, JsonReader json) {
        this.contract = contract;
        this.caller = caller;
        this.rest = rest;
        this.json = json;
    }

    /** A call under way. */
    record Called(
            SoapOperation operation, HttpServletRequest from, CalledBy by, CompletableFuture<RestAnswer> answer) {}

    /** {@code payload}: what stands in the body of the message; null: nothing. */
    Called begin(String service, @Nullable Element payload, Message message, HttpServletRequest from) {
        SoapServices services = contract.services();
        try {
            if (payload == null) {
                throw Rejection.of(
                        RequestProblem.REQUEST_UNREADABLE,
                        "The body of a SOAP message must have the element of an operation.");
            }
            SoapOperation operation = operation(services, service, payload);
            // Until REST keeps the record.
            Activity.current().ifPresent(call -> call.operation(operation.name()));
            var request = new CallReader(services.types(), json.mapper()).read(operation, payload);
            CalledBy by = caller.of(message, from);
            return new Called(operation, from, by, rest.call(from, request, by));
        } catch (Rejection rejection) {
            throw fault(Problem.of(rejection));
        }
    }

    private static SoapOperation operation(SoapServices services, String service, Element payload) {
        if (!Namespace.URI.equals(payload.getNamespaceURI())) {
            throw Rejection.of(
                    RequestProblem.REQUEST_UNREADABLE,
                    "The element " + payload.getLocalName() + " must be in the namespace " + Namespace.URI
                            + "; it is in " + payload.getNamespaceURI() + ".");
        }
        return services.service(service)
                .flatMap(one -> one.operation(payload.getLocalName()))
                .orElseThrow(() -> Rejection.of(
                        RequestProblem.OPERATION_UNKNOWN,
                        service + " has no operation " + payload.getLocalName() + "; its description lists them."));
    }

    /** The message for the answer, which is there. */
    Source answer(Called called) {
        RestAnswer answer = called.answer().getNow(null);
        if (answer == null) {
            throw fault(Problem.of(
                    Rejection.of(ServerProblem.OUTCOME_NOT_KNOWN, "The outcome is not known yet; ask for it later.")));
        }
        if (answer.tooLong()) {
            throw fault(Problem.of(tooLong(called)));
        }
        if (answer.getStatus() < FIRST_REFUSAL) {
            return message(called, answer);
        }
        JsonNode problem = problem(answer);
        if (problem.path(COMMAND_ID).isString() && isCommand(called.operation())) {
            return refused(called, problem);
        }
        throw ProblemFault.of(problem, contract.services().types());
    }

    private static boolean isCommand(SoapOperation operation) {
        return operation.answer() != null && operation.answer().type().equals(COMMAND);
    }

    /** A command that was refused has an outcome like any other. */
    private Source refused(Called called, JsonNode problem) {
        String uri = "/api/v1/commands/" + problem.path(COMMAND_ID).asString();
        var look = new RestRequest("GET", uri, Map.of());
        RestAnswer command = rest.call(called.from(), look, called.by()).getNow(null);
        if (command == null || command.getStatus() >= FIRST_REFUSAL) {
            throw ProblemFault.of(problem, contract.services().types());
        }
        return message(called, command);
    }

    private Source message(Called called, RestAnswer answer) {
        return AnswerMessage.of(contract.services().types(), json.mapper(), called.operation(), answer);
    }

    private JsonNode problem(RestAnswer answer) {
        try {
            JsonNode problem = json.mapper().readTree(answer.text());
            if (problem.isObject()) {
                return problem;
            }
        } catch (JacksonException notJson) {
            // Told below: there is no sentence of its own.
        }
        return json.mapper().valueToTree(Problem.ofStatus(answer.getStatus()));
    }

    private static Rejection tooLong(Called called) {
        return Rejection.of(
                RequestProblem.ANSWER_TOO_LARGE,
                "This answer is longer than a SOAP message may be, " + RestAnswer.LONGEST_BYTES + " bytes; get it by "
                        + called.operation().of().method() + " "
                        + called.operation().of().path()
                        + " with the same key, or ask for less.");
    }

    SoapFault fault(Problem problem) {
        AuditNotes.turnedAway(problem);
        return ProblemFault.of(
                json.mapper().valueToTree(problem), contract.services().types());
    }
}
