package org.dronemap.example;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.time.Duration;
import org.dronemap.example.rest.ApiClient;
import org.dronemap.example.rest.ApiException;
import org.dronemap.example.rest.model.Problem;

/** Calls by REST with an access key, whose failures are sentences. */
final class RestCalls {
    /** Longer than a call that waits for the outcome of a command. */
    private static final Duration LONGEST = Duration.ofSeconds(60);

    interface Call<T> {
        T send() throws ApiException;
    }

    private RestCalls() {}

    static ApiClient client(Connection connection) {
        ApiClient client = new ApiClient();
        client.updateBaseUri(connection.server());
        client.setConnectTimeout(Duration.ofSeconds(10));
        client.setReadTimeout(LONGEST);
        client.setRequestInterceptor(request -> request.header("Authorization", "Bearer " + connection.key()));
        return client;
    }

    static <T> T orProblem(Call<T> call) throws FlightException {
        try {
            return call.send();
        } catch (ApiException e) {
            throw failed(e);
        }
    }

    private static FlightException failed(ApiException e) {
        if (e.getResponseBody() == null) {
            return FlightException.ofNoAnswer(e);
        }
        try {
            Problem problem = ApiClient.createDefaultObjectMapper().readValue(e.getResponseBody(), Problem.class);
            // A command that the server refused has an id, and is in the drone's history.
            String refused = problem.getCommandId() == null ? "" : "refused: ";
            return FlightException.ofProblem(e.getCode(), refused + problem.getDetail(), problem.getCode(), e);
        } catch (JsonProcessingException noProblem) {
            // Of something in between, such as a proxy.
            e.addSuppressed(noProblem);
            return new FlightException("The answer is none of a Dronemap server: " + e.getMessage(), e);
        }
    }
}
